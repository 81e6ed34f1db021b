#include "app/bench/burn_run.h"

#include <cmath>
#include <limits>

#include "app/bench/bench_run.h"
#include "app/stats_json.h"

namespace ember {
namespace {

double burnt_share(const World& world) {
    const PhaseCounts counts = count_phases(world.state());
    return static_cast<double>(counts.burnt_out) / static_cast<double>(counts.total());
}

double mean_shrink(const WorldState& before, const WorldState& after) {
    double sum = 0, count = 0;
    for (std::size_t s = 0; s < before.sheets.size(); ++s) {
        const std::vector<double>& initial = before.sheets[s].rest_length;
        for (std::size_t i = 0; i < initial.size(); ++i) {
            if (!(initial[i] > 0)) continue;
            sum += after.sheets[s].rest_length[i] / initial[i];
            ++count;
        }
    }
    return sum / count;
}

// Where a share that rises from `a` to `b` within a tick passes `level`.
double crossing(double time, double dt, double a, double b, double level) {
    return time - dt * (b - level) / (b - a);
}

}  // namespace

BurnRun run_burn(const Params& params, double duration) {
    constexpr std::array<double, 3> kLevels = {0.1, 0.5, 0.9};
    World world = make_world(params);
    const WorldState before = world.snapshot();
    BurnRun run;
    run.measures.fill(std::numeric_limits<double>::quiet_NaN());
    double share = 0;
    while (world.state().time < duration - 1e-9) {
        const double start = thread_seconds();
        const StepReport report = world.step();
        run.seconds += thread_seconds() - start;
        run.right_hand_sides += report.counters.right_hand_sides;
        run.failed = !report.ok();
        if (run.failed) return run;
        const double now = burnt_share(world);
        for (std::size_t i = 0; i < kLevels.size(); ++i) {
            if (now >= kLevels[i] && std::isnan(run.measures[i])) {
                run.measures[i] =
                    crossing(world.state().time, world.tick_duration(), share, now, kLevels[i]);
            }
        }
        share = now;
    }
    run.measures[3] = share;
    run.measures[4] = mean_shrink(before, world.state());
    run.cuts = world.state().totals.cuts;
    return run;
}

}  // namespace ember
