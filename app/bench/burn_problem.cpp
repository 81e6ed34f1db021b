#include "app/bench/burn_problem.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "app/bench/burn_run.h"
#include "app/bench/shipped_defaults.h"
#include "app/progress.h"
#include "sim/integrator.h"
#include "sim/stability.h"

namespace ember {
namespace {

constexpr double kDuration = 10.0;  // [s]
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
using SeedRuns = std::vector<BurnRun>;  // one per seed

Params burn_params(const WorkSetting& setting, std::size_t seed) {
    Params params = bench_params("paper/corner", setting.sets);
    params.numerics.seed = static_cast<std::int64_t>(seed) + 1;
    return params;
}

// What asks for steps of different fineness: a share of the stability bound where there is one.
std::vector<WorkSetting> burn_settings(bool quick) {
    using Texts = std::vector<std::string>;
    const Texts safeties =
        quick ? Texts{"0.9", "0.5"} : Texts{"0.9", "0.8", "0.7", "0.6", "0.5", "0.4", "0.3"};
    const Texts tolerances = quick ? Texts{"1e-4", "1e-6"}
                                   : Texts{"1e-3", "1e-4", "1e-5", "1e-6", "1e-7", "1e-8", "1e-9"};
    const Texts counts = quick ? Texts{"1", "4"} : Texts{"1", "2", "4", "8", "12", "16", "24"};
    std::vector<WorkSetting> settings;
    for (const std::string& method : choices_of("numerics.integrator")) {
        const std::string integrator = "numerics.integrator=" + method;
        Params params;
        set_params(params, {integrator});
        const IntegratorKind kind = params.numerics.integrator;
        const bool unbounded = std::isinf(stable_step(kind, {.omega = 1, .gamma = 1}));
        const bool adaptive = has_error_control(kind);
        const std::string key = adaptive ? "tolerance" : unbounded ? "substeps_min" : "safety";
        const std::string label = key + ' ', setting = "numerics." + key + '=';
        for (const std::string& value : adaptive ? tolerances : unbounded ? counts : safeties)
            settings.push_back({method, label + value, {integrator, setting + value}});
    }
    return settings;
}

// Spread of each measure between seeds; NaN where a measure was not reached by every seed.
std::vector<double> seed_spread(const SeedRuns& runs) {
    std::vector<double> spread;
    for (std::size_t m = 0; m < kBurnMeasures.size(); ++m) {
        std::vector<double> values;
        for (const BurnRun& run : runs)
            values.push_back(run.measures[m]);
        spread.push_back(deviation(values));
    }
    return spread;
}

// {over all measures in units of the spread, each measure}
std::vector<double> burn_errors(const SeedRuns& runs, const SeedRuns& reference,
                                const std::vector<double>& spread) {
    std::vector<double> errors = {0}, relative;
    for (std::size_t m = 0; m < kBurnMeasures.size(); ++m) {
        std::vector<double> differences;
        for (std::size_t s = 0; s < runs.size(); ++s)
            differences.push_back(runs[s].measures[m] - reference[s].measures[m]);
        errors.push_back(root_mean_square(differences));
        if (spread[m] > 0) relative.push_back(errors.back() / spread[m]);
    }
    errors[0] = relative.empty() ? kNaN : root_mean_square(relative);
    return errors;
}

void summarise(const SeedRuns& runs, const SeedRuns& reference, const std::vector<double>& spread,
               WorkPoint& point) {
    for (const BurnRun& run : runs) {
        point.seconds += run.seconds / static_cast<double>(runs.size());
        point.work += run.right_hand_sides / static_cast<std::int64_t>(runs.size());
        point.failed |= run.failed;
    }
    point.errors.assign(1 + kBurnMeasures.size(), kNaN);
    if (!point.failed) point.errors = burn_errors(runs, reference, spread);
    point.failed |= !std::isfinite(point.errors[0]);
}

std::string reference_text(const WorkSetting& setting, const SeedRuns& runs, double chaos) {
    std::string text = "The reference is " + setting.method + " with " + setting.label + ", over " +
                       std::to_string(runs.size()) + " seeds. Mean and spread between seeds:";
    for (std::size_t m = 0; m < kBurnMeasures.size(); ++m) {
        std::vector<double> values;
        for (const BurnRun& run : runs)
            values.push_back(run.measures[m]);
        text += (m == 0 ? " " : ", ") + std::string(kBurnMeasures[m]) + ' ' +
                short_text(mean(values), 4) + " +- " + short_text(deviation(values), 2);
    }
    return text +
           ". Burns are chaotic: a second run as fine as the reference, by another "
           "integrator, is " +
           short_text(chaos) +
           " spreads away from it. Runs nearer than that, or than one spread, "
           "are as good as exact.";
}

// Each setting with each seed. Says how far it is, since all of them take half an hour.
void run_burns(const std::vector<WorkSetting>& settings, int threads, std::vector<SeedRuns>& runs) {
    const std::size_t seeds = runs.front().size(), count = settings.size() * seeds;
    Progress progress("burns", static_cast<long>(count), Progress::style_of("auto", false));
    std::mutex one_at_a_time;
    long done = 0;
    run_jobs(count, threads, [&](std::size_t i) {
        const std::size_t which = i / seeds, seed = i % seeds;
        runs[which][seed] = run_burn(burn_params(settings[which], seed), kDuration);
        const std::lock_guard lock(one_at_a_time);
        progress.update(++done);
    });
    progress.finish();
}

}  // namespace

WorkProblem measure_burn(const BenchOptions& options) {
    const std::size_t seeds = options.quick ? 2 : 8;
    WorkProblem problem;
    problem.name = "burn";
    problem.title = "Burn: a corner of an A4 sheet is lit, 10 s";
    problem.subtitle = "paper/corner, " + std::to_string(seeds) +
                       " seeds; error over t10, t50, t90, burnt share and shrink";
    problem.work_title = "right-hand sides";
    problem.error_titles = {"RMS error / spread between seeds [1]"};
    problem.error_titles.insert(problem.error_titles.end(), kBurnMeasures.begin(),
                                kBurnMeasures.end());
    // two references first, then the sweep, then what ships
    const std::string finest = options.quick ? "1e-7" : "1e-9";
    std::vector<WorkSetting> all = {
        {"rkf78",
         "tolerance " + finest,
         {"numerics.integrator=rkf78", "numerics.tolerance=" + finest}},
        {"dopri5",
         "tolerance " + finest,
         {"numerics.integrator=dopri5", "numerics.tolerance=" + finest}}};
    for (const WorkSetting& setting : burn_settings(options.quick)) {
        problem.points.push_back({.setting = setting});
        all.push_back(setting);
    }
    problem.defaults = shipped_defaults(PresetKind::Burns);
    for (const WorkPoint& point : problem.defaults)
        all.push_back(point.setting);

    std::vector<SeedRuns> runs(all.size(), SeedRuns(seeds));
    run_burns(all, options.threads, runs);
    const std::vector<double> spread = seed_spread(runs[0]);
    const double chaos = burn_errors(runs[1], runs[0], spread)[0];
    problem.floor = std::max(1.0, chaos);
    problem.floor_name = "chaos and seeds";
    problem.reference = reference_text(all[0], runs[0], chaos);
    for (std::size_t i = 2; i < all.size(); ++i) {
        const std::size_t p = i - 2, sweep = problem.points.size();
        summarise(runs[i], runs[0], spread,
                  p < sweep ? problem.points[p] : problem.defaults[p - sweep]);
    }
    return problem;
}

}  // namespace ember
