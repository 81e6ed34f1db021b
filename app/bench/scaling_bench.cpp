#include <algorithm>
#include <cstdio>
#include <thread>

#include "app/bench/benches.h"
#include "app/bench/chart.h"
#include "app/exit_code.h"
#include "app/preset_io/atomic_file.h"
#include "app/stage_clock.h"

namespace ember {
namespace {

constexpr double kLife = 2.0;        // [s] of a particle, long enough for many of them
constexpr double kLongestRun = 5.0;  // [s] of wall time per measurement
constexpr std::size_t kMostTicks = 40;

struct ScalingCase {
    int rows, columns, threads;
    int particles;  // about
};

struct ScalingResult {
    ScalingCase asked;
    std::size_t nodes = 0, particles = 0;
    double tick = 0;                           // [ms] median
    std::array<double, kStageCount> stages{};  // [ms] medians
    StepCounters work{};                       // of the last tick

    [[nodiscard]] double of_springs() const { return stages[index_of(Stage::Springs)]; }
    [[nodiscard]] double of_fire() const {
        return stages[index_of(Stage::Fire)] + stages[index_of(Stage::Coupling)];
    }
};

std::string threads_text(int threads) {
    return std::to_string(threads) + (threads == 1 ? " thread" : " threads");
}

Params scaling_params(const ScalingCase& c) {
    Params params = bench_params("paper/corner");
    params.sheet.rows = c.rows;
    params.sheet.columns = c.columns;
    params.lighter.on = c.particles > 0;
    params.lighter.rate = c.particles / kLife;
    params.lighter.duration = 3600;
    params.fire.life_min = params.fire.life_max = kLife;
    return params;
}

// The fire of a lighter that has burnt for as long as a particle lives; made on the smallest
// lattice, since growing it takes many ticks.
WorldState grown_fire(const ScalingCase& c) {
    Params params = scaling_params({1, 1, 1, c.particles});
    params.fire.heating = 0;
    World world = make_world(params);
    while (world.state().time < kLife) {
        if (!world.step().ok()) throw RunError("scaling: the lighter alone cannot be simulated");
    }
    return world.snapshot();
}

World burning_world(const ScalingCase& c) {
    World world = make_world(scaling_params(c), c.threads);
    if (c.particles == 0) return world;
    const WorldState grown = grown_fire(c);
    WorldState state = world.snapshot();
    state.fire = grown.fire;
    state.time = grown.time;
    state.tick = grown.tick;
    world.restore(std::move(state));
    return world;
}

ScalingResult measure(const ScalingCase& c) {
    World world = burning_world(c);
    StageClock clock;
    std::vector<double> ticks;
    std::array<std::vector<double>, kStageCount> stages;
    ScalingResult result{.asked = c};
    const double begin = wall_seconds();
    for (std::size_t tick = 0; tick < kMostTicks; ++tick) {
        clock.reset();
        const double start = wall_seconds();
        const StepReport report = world.step(&clock);
        const double now = wall_seconds();
        if (!report.ok()) throw RunError("scaling: " + report.reason);
        result.work = report.counters;
        if (tick == 0) continue;  // warms up
        ticks.push_back(1e3 * (now - start));
        for (std::size_t s = 0; s < kStageCount; ++s)
            stages[s].push_back(clock.milliseconds()[s]);
        if (tick >= 3 && now - begin > kLongestRun) break;
    }
    result.tick = median(ticks);
    for (std::size_t s = 0; s < kStageCount; ++s)
        result.stages[s] = median(stages[s]);
    result.nodes = world.state().sheets.front().mass.size();
    result.particles = world.state().fire.size();
    return result;
}

std::vector<ScalingCase> scaling_cases(const BenchOptions& options) {
    constexpr std::array<int, 7> kRows = {16, 32, 64, 128, 256, 512, 1024};
    std::vector<int> teams;
    for (int threads = 1; threads < options.threads; threads *= 2)
        teams.push_back(threads);
    teams.push_back(options.threads);
    std::vector<ScalingCase> cases;
    for (const int rows : kRows) {
        if (options.quick && rows > 64) continue;
        for (const int threads : teams)
            cases.push_back({rows, rows * 3 / 2, threads, 0});
        for (const int particles : {2000, 20000, 200000}) {
            if (options.quick && particles > 20000) continue;
            cases.push_back({rows, rows * 3 / 2, options.threads, particles});
        }
    }
    return cases;
}

std::string size_text(const ScalingCase& c) {
    return std::to_string(c.rows) + 'x' + std::to_string(c.columns);
}

std::string scaling_csv(const std::vector<ScalingResult>& results) {
    std::vector<std::string> columns = {"cells", "nodes", "threads", "particles", "ms per tick"};
    for (const std::string_view stage : kStageNames)
        columns.push_back("ms " + std::string(stage));
    columns.insert(columns.end(), {"sub-steps", "right-hand sides", "coupling pairs"});
    CsvTable table(columns);
    for (const ScalingResult& r : results) {
        std::vector<std::string> cells = {size_text(r.asked), std::to_string(r.nodes),
                                          std::to_string(r.asked.threads),
                                          std::to_string(r.particles), short_text(r.tick, 5)};
        for (const double ms : r.stages)
            cells.push_back(short_text(ms, 5));
        cells.insert(cells.end(),
                     {std::to_string(r.work.substeps), std::to_string(r.work.right_hand_sides),
                      std::to_string(r.work.coupling_pairs)});
        table.add(cells);
    }
    return table.text();
}

void add_point(LineChart& chart, const std::string& name, double x, double y) {
    if (!(y > 0)) return;  // nothing was done
    for (ChartSeries& series : chart.series) {
        if (series.name == name) return series.points.push_back({x, y});
    }
    chart.series.push_back({name, {{x, y}}});
}

void write_charts(const std::vector<ScalingResult>& results, const std::filesystem::path& out) {
    LineChart threads{.title = "Time per tick without fire",
                      .subtitle = "paper/corner, by number of threads",
                      .x_title = "nodes",
                      .y_title = "time per tick [ms]"};
    LineChart stages = threads;
    stages.title = "Time per stage, one thread";
    stages.subtitle = "paper/corner without fire; stages that take no time are left out";
    LineChart particles{.title = "Time for fire and its coupling to the sheet",
                        .subtitle = "paper/corner, by lattice",
                        .x_title = "fire particles",
                        .y_title = "time per tick of fire and coupling [ms]"};
    for (const ScalingResult& r : results) {
        const auto nodes = static_cast<double>(r.nodes);
        if (r.asked.particles > 0) {
            add_point(particles, size_text(r.asked), static_cast<double>(r.particles), r.of_fire());
            continue;
        }
        add_point(threads, threads_text(r.asked.threads), nodes, r.tick);
        for (std::size_t s = 0; s < kStageCount && r.asked.threads == 1; ++s)
            add_point(stages, std::string(kStageNames[s]), nodes, r.stages[s]);
    }
    write_file(out / "scaling_threads.svg", chart_svg(threads));
    write_file(out / "scaling_stages.svg", chart_svg(stages));
    write_file(out / "scaling_particles.svg", chart_svg(particles));
}

}  // namespace

int bench_scaling(const BenchOptions& options) {
    std::vector<ScalingResult> results;
    for (const ScalingCase& c : scaling_cases(options)) {
        results.push_back(measure(c));
        const ScalingResult& r = results.back();
        std::printf(
            "%-10s %-10s %7zu particles %10.3f ms per tick (springs %.3f, fire and coupling "
            "%.3f)\n",
            size_text(c).c_str(), threads_text(c.threads).c_str(), r.particles, r.tick,
            r.of_springs(), r.of_fire());
        std::fflush(stdout);
    }
    write_file(options.out / "scaling.csv", scaling_csv(results));
    write_charts(results, options.out);
    return kOk;
}

}  // namespace ember
