// What a long run is judged by: a row for each round, and whether they stay alike.
#pragma once

#include <string>
#include <vector>

namespace ember {

struct SoakRound {
    double minutes = 0;     ///< since the beginning, at the round's end
    double megabytes = 0;   ///< resident set
    int gl_objects = 0;     ///< in the context
    double tick_ms = 0;     ///< mean of a tick
    double picture_ms = 0;  ///< mean of a picture
    std::string hashes;     ///< of the states at the end of each preset
};

struct SoakVerdict {
    double slope = 0;       ///< [MB/h] of the resident set, least squares after the first quarter
    double tick_drift = 0;  ///< [%] last quarter against the second one
    double picture_drift = 0;  ///< [%]
    std::vector<std::string> faults;
};

/// Faults are: GL objects that become more, another hash than in the first round, and, over half an
/// hour and more, a slope above 1 MB/h. Times are shown and never judged.
[[nodiscard]] SoakVerdict judge(const std::vector<SoakRound>& rounds);

/// At most `most` rows, evenly chosen, and the verdict, as text.
[[nodiscard]] std::string soak_table(const std::vector<SoakRound>& rounds, std::size_t most = 24);

}  // namespace ember
