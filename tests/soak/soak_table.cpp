#include "soak_table.h"

#include <algorithm>
#include <cstdio>

namespace ember {
namespace {

constexpr double kLongRun = 30;       // [min]
constexpr double kSteepestSlope = 1;  // [MB/h]

double slope_per_hour(const std::vector<SoakRound>& rounds, std::size_t first) {
    double n = 0, t = 0, m = 0, tt = 0, tm = 0;
    for (std::size_t i = first; i < rounds.size(); ++i) {
        const double hours = rounds[i].minutes / 60, size = rounds[i].megabytes;
        n += 1, t += hours, m += size, tt += hours * hours, tm += hours * size;
    }
    const double spread = n * tt - t * t;
    return spread > 0 ? (n * tm - t * m) / spread : 0;
}

// [%] by which the mean of the last quarter of the rounds is above that of the second one.
double drift(const std::vector<SoakRound>& rounds, double SoakRound::*member) {
    const std::size_t quarter = rounds.size() / 4;
    if (quarter == 0) return 0;
    double early = 0, late = 0;
    for (std::size_t i = 0; i < quarter; ++i) {
        early += rounds[quarter + i].*member;
        late += rounds[rounds.size() - 1 - i].*member;
    }
    return early > 0 ? 100 * (late / early - 1) : 0;
}

template <class... Values>
std::string line(const char* format, Values... values) {
    char text[160];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

}  // namespace

SoakVerdict judge(const std::vector<SoakRound>& rounds) {
    SoakVerdict verdict;
    verdict.slope = slope_per_hour(rounds, rounds.size() / 4);
    verdict.tick_drift = drift(rounds, &SoakRound::tick_ms);
    verdict.picture_drift = drift(rounds, &SoakRound::picture_ms);
    if (rounds.back().gl_objects > rounds.front().gl_objects)
        verdict.faults.push_back("GL objects are left behind");
    const auto other = [&](const SoakRound& r) { return r.hashes != rounds.front().hashes; };
    if (std::ranges::any_of(rounds, other))
        verdict.faults.push_back("a preset has not burnt as in the first round");
    if (rounds.back().minutes >= kLongRun && verdict.slope > kSteepestSlope)
        verdict.faults.push_back("memory grows");
    return verdict;
}

std::string soak_table(const std::vector<SoakRound>& rounds, std::size_t most) {
    std::string text = "round   minutes   RSS [MB]   GL objects   tick [ms]   picture [ms]\n";
    const std::size_t stride = (rounds.size() + most - 1) / most;
    for (std::size_t i = 0; i < rounds.size(); ++i) {
        if (i % stride != 0 && i + 1 != rounds.size()) continue;
        const SoakRound& r = rounds[i];
        text += line("%5zu   %7.1f   %8.1f   %10d   %9.3f   %12.2f\n", i + 1, r.minutes,
                     r.megabytes, r.gl_objects, r.tick_ms, r.picture_ms);
    }
    const SoakVerdict verdict = judge(rounds);
    text += line("RSS slope %+.2f MB/h, drift of a tick %+.1f %%, of a picture %+.1f %%\n",
                 verdict.slope, verdict.tick_drift, verdict.picture_drift);
    for (const std::string& fault : verdict.faults)
        text += "FAULT: " + fault + '\n';
    return text;
}

}  // namespace ember
