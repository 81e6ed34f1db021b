#include "app/bench/swing_problem.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/bench/shipped_defaults.h"
#include "sim/integrator.h"

namespace ember {
namespace {

constexpr double kTimes[] = {0.25, 0.5};  // [s]
constexpr double kAgreement = 1e-10;      // [m] that independent references must reach
constexpr double kNowhere = 10.0;         // [m] an error that no sheet of 0.3 m can have
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

struct SwingRun {
    std::vector<Vector3Array> positions;  // at kTimes; fewer when it failed
    double seconds = 0;
    std::int64_t right_hand_sides = 0;
};

SwingRun run_swing(const Params& params) {
    World world = make_world(params);
    SwingRun run;
    for (const double time : kTimes) {
        const double start = thread_seconds();
        while (world.state().time < time - 1e-9) {
            const StepReport report = world.step();
            run.right_hand_sides += report.counters.right_hand_sides;
            if (!report.ok()) return run;
        }
        run.seconds += thread_seconds() - start;
        run.positions.push_back(world.state().sheets.front().position);
    }
    return run;
}

// RMS distance of the nodes [m].
double distance(const Vector3Array& a, const Vector3Array& b) {
    std::vector<double> apart;
    for (std::size_t n = 0; n < a.size(); ++n)
        apart.push_back((a.at(n) - b.at(n)).norm());
    return root_mean_square(apart);
}

// The sub-step is what the bench asks for: one tick is one output, and the bound hardly acts.
Params swing_params() {
    return bench_params("bench/swing",
                        {"numerics.tick_rate=4", "numerics.check=false", "numerics.safety=10"});
}

std::vector<WorkSetting> swing_settings(bool quick) {
    std::vector<WorkSetting> settings;
    for (const std::string& method : choices_of("numerics.integrator")) {
        const std::string integrator = "numerics.integrator=" + method;
        Params params;
        set_params(params, {integrator});
        const int count = quick ? 7 : 10;
        for (int i = 0; i < count; ++i) {
            if (has_error_control(params.numerics.integrator)) {
                const std::string tolerance = "1e-" + std::to_string(2 + i);
                settings.push_back({method,
                                    "tolerance " + tolerance + " m",
                                    {integrator, "numerics.tolerance=" + tolerance}});
            } else {
                const std::string substeps = std::to_string(8 << i);
                settings.push_back({method,
                                    substeps + " sub-steps per 0.25 s",
                                    {integrator, "numerics.substeps_min=" + substeps}});
            }
        }
    }
    return settings;
}

struct Reference {
    SwingRun run;
    std::string text;
};

Reference find_reference(int threads) {
    const WorkSetting ways[] = {
        {"rkf78", "tolerance 1e-13 m", {"numerics.integrator=rkf78", "numerics.tolerance=1e-13"}},
        {"rk4",
         "16384 sub-steps per 0.25 s",
         {"numerics.integrator=rk4", "numerics.substeps_min=16384"}},
        {"adams_bashforth_moulton",
         "4096 sub-steps per 0.25 s",
         {"numerics.integrator=adams_bashforth_moulton", "numerics.substeps_min=4096"}}};
    SwingRun runs[std::size(ways)];
    run_jobs(std::size(ways), threads, [&](std::size_t i) {
        Params params = swing_params();
        set_params(params, ways[i].sets);
        runs[i] = run_swing(params);
    });
    Reference reference{runs[0], "The reference is " + ways[0].method + " with " + ways[0].label +
                                     ". RMS distance of other runs from it at 0.25 and 0.5 s:"};
    bool good = runs[0].positions.size() == 2;
    for (std::size_t i = 1; i < std::size(ways); ++i) {
        reference.text += ' ' + ways[i].method + " with " + ways[i].label;
        double worst = std::numeric_limits<double>::infinity();
        if (good && runs[i].positions.size() == 2) {
            worst = 0;
            for (std::size_t k = 0; k < 2; ++k) {
                const double apart = distance(runs[0].positions[k], runs[i].positions[k]);
                reference.text += (k == 0 ? ": " : " and ") + short_text(apart, 2) + " m";
                worst = std::max(worst, apart);
            }
        }
        reference.text += i + 1 < std::size(ways) ? ";" : ".";
        good = good && worst <= kAgreement;
    }
    reference.text += good ? " They agree to 1e-10 m." : " WARNING: they do not agree to 1e-10 m.";
    return reference;
}

void measure_point(const SwingRun& reference, int repeats, WorkPoint& point) {
    Params params = swing_params();
    set_params(params, point.setting.sets);
    std::vector<double> seconds;
    SwingRun run;
    for (int i = 0; i < repeats; ++i) {
        run = run_swing(params);
        seconds.push_back(run.seconds);
        if (run.seconds > 2.0) break;  // long runs vary little
    }
    point.seconds = median(seconds);
    point.work = run.right_hand_sides;
    point.errors.assign(std::size(kTimes), kNaN);
    point.failed = run.positions.size() < std::size(kTimes);
    if (point.failed) return;
    // the later time comes first: it ranks
    point.errors = {distance(run.positions[1], reference.positions[1]),
                    distance(run.positions[0], reference.positions[0])};
    point.failed = !(point.errors[0] < kNowhere && point.errors[1] < kNowhere);
}

}  // namespace

WorkProblem measure_swing(const BenchOptions& options) {
    WorkProblem problem;
    problem.name = "swing";
    problem.title = "Swing: a soft sheet falls for 0.5 s";
    problem.subtitle = "32x48 nodes, stiffness as printed, no fire; error at t = 0.5 s";
    problem.work_title = "right-hand sides";
    problem.error_titles = {"RMS node distance at 0.5 s [m]", "RMS node distance at 0.25 s [m]"};
    const Reference reference = find_reference(options.threads);
    problem.reference = reference.text;
    for (const WorkSetting& setting : swing_settings(options.quick))
        problem.points.push_back({.setting = setting});
    problem.defaults = shipped_defaults(PresetKind::OnlyMoves);
    for (WorkPoint& point : problem.defaults)
        point.setting.sets.push_back("numerics.check=false");
    const std::size_t sweep = problem.points.size();
    run_jobs(sweep + problem.defaults.size(), options.threads, [&](std::size_t i) {
        WorkPoint& point = i < sweep ? problem.points[i] : problem.defaults[i - sweep];
        measure_point(reference.run, options.quick ? 3 : 5, point);
    });
    return problem;
}

}  // namespace ember
