#include "app/bench/cosine_problem.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "app/bench/shipped_defaults.h"

namespace ember {
namespace {

constexpr double kTime = 2.0;                          // [s]
constexpr double kOffset = 300.0, kAmplitude = 200.0;  // [K] above ambient
constexpr int kMainWaves = 3, kCrossWaves = 2;         // half waves along and across
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

struct LatticeSize {
    int rows, columns;
};

// A sheet that nothing moves, heats or cools: what is left is conduction.
Params cosine_params(LatticeSize size) {
    Params params = bench_params(
        "paper/corner",
        {"lighter.on=false", "sheet.held=none", "sheet.pose=horizontal", "sheet.imperfection=0",
         "springs.structural=0", "springs.diagonal=0", "springs.bending=0", "springs.damping=0",
         "world.gravity=0", "world.air_drag=0", "world.ground=false", "heat.convection=0",
         "heat.emissivity=0", "numerics.check=false"});
    params.sheet.rows = size.rows;
    params.sheet.columns = size.columns;
    return params;
}

double wave_number(int waves, double length) {
    return waves * std::numbers::pi / length;
}

// The mode at a node of the lattice.
double mode_at(const Params& params, Index row, Index column) {
    const double x = static_cast<double>(column) / params.sheet.columns;
    const double z = static_cast<double>(row) / params.sheet.rows;
    return std::cos(kMainWaves * std::numbers::pi * x) *
           std::cos(kCrossWaves * std::numbers::pi * z);
}

double diffusivity(const PaperParams& paper) {
    return paper.conductivity / (paper.c_s * paper.density * paper.specific_heat);
}

// Decay rate [1/s] of the mode on paper, and on the lattice with continuous time.
double exact_rate(const Params& p) {
    const double a = wave_number(kMainWaves, p.sheet.height);
    const double b = wave_number(kCrossWaves, p.sheet.width);
    return diffusivity(p.paper) * (a * a + b * b);
}
double lattice_rate(const Params& p) {
    const auto squared = [](double wave, double spacing) {
        const double s = 2.0 / spacing * std::sin(0.5 * wave * spacing);
        return s * s;
    };
    return diffusivity(p.paper) *
           (squared(wave_number(kMainWaves, p.sheet.height), p.sheet.height / p.sheet.columns) +
            squared(wave_number(kCrossWaves, p.sheet.width), p.sheet.width / p.sheet.rows));
}

// Processor time of the heat stage alone.
class HeatClock final : public StageObserver {
  public:
    void begin(Stage stage) override {
        if (stage == Stage::Heat) start_ = thread_seconds();
    }
    void end(Stage stage) override {
        if (stage == Stage::Heat) seconds += thread_seconds() - start_;
    }
    double seconds = 0;

  private:
    double start_ = 0;
};

void heat_up(const Params& params, World& world) {
    WorldState state = world.snapshot();
    SheetState& sheet = state.sheets.front();
    for (std::size_t n = 0; n < sheet.temperature.size(); ++n) {
        const Index site = sheet.site[n], columns = params.sheet.columns + 1;
        sheet.temperature[n] = params.heat.ambient + kOffset +
                               kAmplitude * mode_at(params, site / columns, site % columns);
    }
    world.restore(std::move(state));
}

// L2 distance from the mode after decaying to `share`, relative to the mode as it should be.
double relative_error(const Params& params, const World& world, double share) {
    const SheetState& sheet = world.state().sheets.front();
    const double expected = kAmplitude * std::exp(-exact_rate(params) * kTime);
    double wrong = 0, whole = 0;
    for (std::size_t n = 0; n < sheet.temperature.size(); ++n) {
        const Index site = sheet.site[n], columns = params.sheet.columns + 1;
        const double mode = mode_at(params, site / columns, site % columns);
        const double u = sheet.temperature[n] - params.heat.ambient - kOffset;
        const double off = u - kAmplitude * share * mode;
        wrong += off * off;
        whole += expected * mode * expected * mode;
    }
    return std::sqrt(wrong / whole);
}

void measure_point(LatticeSize size, WorkPoint& point) {
    Params params = cosine_params(size);
    set_params(params, point.setting.sets);
    World world = make_world(params);
    heat_up(params, world);
    HeatClock clock;
    point.errors = {kNaN, kNaN};
    while (world.state().time < kTime - 1e-9) {
        const StepReport report = world.step(&clock);
        point.work += report.counters.heat_substeps;
        if (!report.ok()) break;
    }
    point.seconds = clock.seconds;
    point.failed = world.state().time < kTime - 1e-9;
    if (point.failed) return;
    point.errors = {relative_error(params, world, std::exp(-exact_rate(params) * kTime)),
                    relative_error(params, world, std::exp(-lattice_rate(params) * kTime))};
    point.failed = !(point.errors[0] < 1.0);
}

std::vector<WorkSetting> cosine_settings() {
    std::vector<WorkSetting> settings;
    for (const std::string& method : choices_of("numerics.heat_solver")) {
        for (const char* text : {"1", "2", "4", "8", "15", "30", "60", "120"}) {
            // how long a tick is, is not for the heat to choose
            settings.push_back(
                {method,
                 text + std::string(" ticks per second"),
                 {"numerics.heat_solver=" + method, std::string("numerics.tick_rate=") + text},
                 text});
        }
    }
    return settings;
}

WorkProblem measure_lattice(const BenchOptions& options, LatticeSize size) {
    const Params params = cosine_params(size);
    const std::string cells = std::to_string(size.rows) + 'x' + std::to_string(size.columns);
    WorkProblem problem;
    problem.name = "cosine_" + cells;
    problem.title = "Cosine heat: a mode decays for 2 s, " + cells + " cells";
    problem.subtitle = "insulated sheet, 3 by 2 half waves; time of the heat stage alone";
    problem.work_title = "heat sub-steps";
    problem.error_titles = {"relative L2 error [1]", "of it by stepping in time [1]"};
    const double lattice = std::exp((exact_rate(params) - lattice_rate(params)) * kTime) - 1.0;
    problem.floor = 1.05 * lattice;
    problem.floor_name = "made by the lattice";
    problem.reference = "The solution is known. The lattice alone makes an error of " +
                        short_text(lattice) + "; runs within 5 % of it count as alike.";
    for (const WorkSetting& setting : cosine_settings())
        problem.points.push_back({.setting = setting});
    problem.defaults = shipped_defaults(PresetKind::Burns);
    for (WorkPoint& point : problem.defaults) {
        point.setting.group = short_text(bench_params(point.presets.front()).numerics.tick_rate, 9);
        point.setting.sets.insert(point.setting.sets.end(),
                                  {"numerics.check=false", "numerics.sleep_speed=0"});
    }
    const std::size_t sweep = problem.points.size();
    run_jobs(sweep + problem.defaults.size(), options.threads, [&](std::size_t i) {
        measure_point(size, i < sweep ? problem.points[i] : problem.defaults[i - sweep]);
    });
    return problem;
}

}  // namespace

std::vector<WorkProblem> measure_cosine(const BenchOptions& options) {
    std::vector<WorkProblem> problems;
    for (const LatticeSize size : {LatticeSize{32, 48}, {128, 192}, {512, 768}}) {
        if (options.quick && size.rows > 128) continue;
        problems.push_back(measure_lattice(options, size));
    }
    return problems;
}

}  // namespace ember
