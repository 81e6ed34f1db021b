// Work against precision of all solvers on the swing problem.
#include <cmath>
#include <memory>
#include <string>

#include "measure.h"
#include "peer_methods.h"
#include "swing_problem.h"
#include "tables.h"

namespace ember::peers {
namespace {

constexpr int kRows = 32, kColumns = 48;
constexpr double kErrors[] = {1e-3, 1e-5, 1e-7};  // [m]
constexpr double kWorst = 3e-3, kBest = 3e-8;     // [m] errors beyond which a run says nothing
constexpr double kLongestRun = 1.0;               // [s]; what takes longer is left out

// One method with one setting.
struct Run {
    std::string who, method, arithmetic;  // whose right-hand side it calls
    double setting = 0;
    std::function<bool(std::vector<double>& y, std::int64_t& evaluations)> solve;
    double time = 0, error = 0;  // [s] per simulated second, [m]
    std::int64_t evaluations = 0;
};

constexpr struct {
    IntegratorKind kind;
    const char* name;
} kIntegrators[] = {{IntegratorKind::SemiImplicitEuler, "semi_implicit_euler"},
                    {IntegratorKind::VelocityVerlet, "velocity_verlet"},
                    {IntegratorKind::Rk4, "rk4"},
                    {IntegratorKind::Dopri5, "dopri5"},
                    {IntegratorKind::Rkf78, "rkf78"},
                    {IntegratorKind::AdamsBashforthMoulton, "adams_bashforth_moulton"},
                    {IntegratorKind::Rosenbrock, "rosenbrock"}};

// Steps or tolerances, each smaller than the last by `factor`: close enough to each other that no
// method profits from a step that happens to lie just below its limit.
std::vector<double> sweep(double first, double factor, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i)
        values.push_back(first * std::pow(factor, -i));
    return values;
}

std::vector<double> tolerances() {
    return sweep(1e-2, std::pow(10.0, 0.25), 40);
}

std::vector<double> steps(double first) {
    return sweep(first, std::pow(2.0, 0.125), 80);
}

// emberleaf moves the sheet by one tick of the whole duration.
bool solve_by_ember(test::Rig& rig, const SheetState& start, StepControl control,
                    std::vector<double>& y, std::int64_t& evaluations) {
    rig.sheet.position = start.position;
    rig.sheet.velocity = start.velocity;
    rig.counters = {};
    const bool good =
        integrate(rig.mechanics(), rig.sheet, control, rig.scratch, rig.counters).failure ==
        nullptr;
    y = state_of(rig);
    evaluations = rig.counters.right_hand_sides;
    return good;
}

void add_ember(test::Rig& rig, const SheetState& start, const char* arithmetic,
               std::vector<Run>& runs) {
    rig.sheet = start;
    const FastestMotion fastest = rig.fastest();
    for (const auto& integrator : kIntegrators) {
        const double stable = stable_step(integrator.kind, fastest);
        const bool controlled = has_error_control(integrator.kind);
        const double longest = std::isfinite(stable) ? 1.1 * stable : 1.0 / 60;
        for (const double setting : controlled ? tolerances() : steps(longest)) {
            StepControl control{.integrator = integrator.kind, .dt = kDuration};
            if (controlled) {
                control.tolerance = setting;
                control.first_step = stable;
            } else {
                control.substeps = static_cast<std::int64_t>(std::ceil(kDuration / setting));
            }
            runs.push_back({.who = "emberleaf",
                            .method = integrator.name,
                            .arithmetic = arithmetic,
                            .setting = setting,
                            .solve = [&rig, &start, control](auto& y, auto& evaluations) {
                                return solve_by_ember(rig, start, control, y, evaluations);
                            }});
        }
    }
}

void add_peers(RightHandSide& f, const std::vector<double>& start, const char* arithmetic,
               double longest, std::vector<Run>& runs) {
    for (const auto& methods : {odeint_methods(), sundials_methods()}) {
        for (const PeerMethod& method : methods) {
            for (const double setting : method.fixed_step ? steps(longest) : tolerances()) {
                runs.push_back({.who = method.library,
                                .method = method.name,
                                .arithmetic = arithmetic,
                                .setting = setting,
                                .solve = [&f, &start, method, setting](auto& y, auto& evaluations) {
                                    y = start;
                                    f.evaluations = 0;
                                    const bool good = method.solve(f, y, kDuration, setting);
                                    evaluations = f.evaluations;
                                    return good;
                                }});
            }
        }
    }
}

// Solves everything once, each method with ever finer settings until it is precise enough or takes
// too long, and keeps what is within the errors of interest or next to them.
void try_all(const std::vector<double>& reference, std::vector<Run>& runs) {
    std::vector<Run> kept;
    std::string done;  // the method whose finer settings are of no interest
    for (Run& run : runs) {
        const std::string name = run.who + run.method + run.arithmetic;
        if (name == done) continue;
        std::vector<double> y;
        bool good = false;
        const double time = seconds([&] { good = run.solve(y, run.evaluations); });
        run.error = distance(y, reference);
        if (time > kLongestRun || (good && run.error < kBest)) done = name;
        if (good && run.error < kWorst && time <= kLongestRun) kept.push_back(std::move(run));
    }
    runs.swap(kept);
    std::printf("%zu runs are precise enough to be timed.\n", runs.size());
    (void)std::fflush(stdout);
}

void time_all(int repeats, std::vector<Run>& runs) {
    std::vector<std::function<void()>> works;
    std::vector<double> y;
    for (const Run& run : runs) {
        works.emplace_back([&run, &y] {
            std::int64_t evaluations = 0;
            (void)run.solve(y, evaluations);
        });
    }
    const std::vector<double> times = interleaved(works, repeats);
    for (std::size_t i = 0; i < runs.size(); ++i)
        runs[i].time = times[i] / kDuration;
}

// Runs of which none is both slower and less precise than another, by rising time.
std::vector<const Run*> frontier(const std::vector<Run>& runs,
                                 const std::function<bool(const Run&)>& chosen) {
    std::vector<const Run*> sorted, best;
    for (const Run& run : runs) {
        if (chosen(run)) sorted.push_back(&run);
    }
    std::sort(sorted.begin(), sorted.end(),
              [](const Run* p, const Run* q) { return p->time < q->time; });
    for (const Run* run : sorted) {
        if (best.empty() || run->error < best.back()->error) best.push_back(run);
    }
    return best;
}

// Time per simulated second at the given error [m], between runs on logarithmic scales; that of
// the cheapest run when even it errs less, infinite when none is as precise.
double time_at(double error, const std::vector<const Run*>& best) {
    for (std::size_t i = 0; i < best.size(); ++i) {
        if (best[i]->error > error) continue;
        if (i == 0) return best[i]->time;
        const Run &p = *best[i - 1], &q = *best[i];
        const double share = std::log(p.error / error) / std::log(p.error / q.error);
        return p.time * std::pow(q.time / p.time, share);
    }
    return std::numeric_limits<double>::infinity();
}

void print_runs(const std::vector<Run>& runs, std::FILE* csv) {
    std::printf("\n%-10s %-24s %-8s %10s %12s %8s %10s\n", "who", "method", "forces", "setting",
                "s per s", "f calls", "error [m]");
    for (const Run& run : runs) {
        std::printf("%-10s %-24s %-8s %10.3g %12.4g %8lld %10.2e\n", run.who.c_str(),
                    run.method.c_str(), run.arithmetic.c_str(), run.setting, run.time,
                    static_cast<long long>(run.evaluations), run.error);
        if (csv == nullptr) continue;
        std::fprintf(csv, "swing,%s,%s/%s,%.5g,%.5g,%lld,%.4g\n", run.who.c_str(),
                     run.method.c_str(), run.arithmetic.c_str(), run.time, run.setting,
                     static_cast<long long>(run.evaluations), run.error);
    }
}

void print_at_errors(const std::vector<Run>& runs) {
    std::printf("\nMilliseconds per simulated second at an error of\n%-44s", "");
    for (const double error : kErrors)
        std::printf(" %9.0e", error);
    std::printf(" m\n");
    std::string last;
    for (const Run& run : runs) {
        const std::string name = run.who + run.method + run.arithmetic;
        if (name == last) continue;
        last = name;
        const auto best =
            frontier(runs, [&](const Run& r) { return r.who + r.method + r.arithmetic == name; });
        std::printf("%-10s %-24s %-8s", run.who.c_str(), run.method.c_str(),
                    run.arithmetic.c_str());
        for (const double error : kErrors)
            std::printf(" %9.3f", 1e3 * time_at(error, best));
        std::printf("\n");
    }
}

// Our best and theirs.
void print_ratios(const std::vector<Run>& runs) {
    std::printf("\nFastest peer over emberleaf's best at an error of\n");
    for (const char* ours : {"exact", "fast"}) {
        const auto best = frontier(
            runs, [&](const Run& r) { return r.who == "emberleaf" && r.arithmetic == ours; });
        for (const char* theirs : {"exact", "fast", "plain"}) {
            const auto peers = frontier(
                runs, [&](const Run& r) { return r.who != "emberleaf" && r.arithmetic == theirs; });
            std::printf("emberleaf %-6s peers with %-6s forces     ", ours, theirs);
            for (const double error : kErrors)
                std::printf("   %.0e m: %5.2f", error,
                            time_at(error, peers) / time_at(error, best));
            std::printf("\n");
        }
    }
}

}  // namespace

void compare_solvers(int repeats, std::FILE* csv) {
    test::Rig exact = make_swing(kRows, kColumns, Arithmetic::Exact);
    test::Rig fast = make_swing(kRows, kColumns, Arithmetic::Fast);
    const SheetState start = exact.sheet;
    const std::vector<double> start_state = state_of(exact);
    const PlainProblem problem = translate(exact);
    const auto plain = plain_right_hand_side(problem);

    std::vector<double> reference, second = start_state;
    std::int64_t evaluations = 0;
    const StepControl tight{.integrator = IntegratorKind::Rkf78,
                            .dt = kDuration,
                            .tolerance = 1e-13,
                            .first_step = 1e-3};
    (void)solve_by_ember(exact, start, tight, reference, evaluations);
    (void)odeint_methods()[2].solve(*plain, second, kDuration, 1e-13);
    std::printf("\nSwing, %d x %d nodes, %g s. Two references differ by %.1e m.\n", kRows, kColumns,
                kDuration, distance(reference, second));

    // the peers' own copies of the forces' scratch
    test::Rig exact_forces = make_swing(kRows, kColumns, Arithmetic::Exact);
    test::Rig fast_forces = make_swing(kRows, kColumns, Arithmetic::Fast);
    const auto by_exact = ember_right_hand_side(exact_forces);
    const auto by_fast = ember_right_hand_side(fast_forces);
    const double longest = 1.1 * stable_step(IntegratorKind::Rk4, exact.fastest());
    std::vector<Run> runs;
    add_ember(exact, start, "exact", runs);
    add_ember(fast, start, "fast", runs);
    add_peers(*by_exact, start_state, "exact", longest, runs);
    add_peers(*by_fast, start_state, "fast", longest, runs);
    add_peers(*plain, start_state, "plain", longest, runs);
    try_all(reference, runs);
    time_all(repeats, runs);
    print_runs(runs, csv);
    print_at_errors(runs);
    print_ratios(runs);
}

}  // namespace ember::peers
