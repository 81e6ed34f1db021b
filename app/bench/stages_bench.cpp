#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/bench/benches.h"
#include "app/bench/chart.h"
#include "app/exit_code.h"
#include "app/preset_io/atomic_file.h"
#include "app/run_options.h"
#include "app/stats_json.h"

namespace ember {
namespace {

struct CounterColumn {
    const char* name;
    std::int64_t StepCounters::*field;
};
constexpr CounterColumn kCounters[] = {{"particles moved", &StepCounters::particles_moved},
                                       {"coupling pairs", &StepCounters::coupling_pairs},
                                       {"sub-steps", &StepCounters::substeps},
                                       {"right-hand sides", &StepCounters::right_hand_sides},
                                       {"spring evaluations", &StepCounters::spring_evaluations},
                                       {"solver iterations", &StepCounters::solver_iterations},
                                       {"heat sub-steps", &StepCounters::heat_substeps},
                                       {"heat nodes", &StepCounters::heat_nodes},
                                       {"nodes burning", &StepCounters::nodes_burning},
                                       {"springs shrunk", &StepCounters::springs_shrunk},
                                       {"cuts", &StepCounters::cuts},
                                       {"contacts", &StepCounters::contacts}};

// One simulated second: means per tick.
struct SecondStats {
    int number = 0;
    std::array<double, kStageCount> ms{};
    std::array<double, std::size(kCounters)> work{};
    double ticks = 0;
};

std::vector<SecondStats> by_second(const std::vector<TickStats>& ticks) {
    std::vector<SecondStats> seconds;
    for (const TickStats& t : ticks) {
        const int number = static_cast<int>(std::ceil(t.time - 1e-9)) - 1;
        if (seconds.empty() || seconds.back().number != number) {
            seconds.push_back({.number = number});
        }
        SecondStats& second = seconds.back();
        for (std::size_t s = 0; s < kStageCount; ++s)
            second.ms[s] += t.ms[s];
        for (std::size_t c = 0; c < std::size(kCounters); ++c)
            second.work[c] += static_cast<double>(t.work.*kCounters[c].field);
        ++second.ticks;
    }
    for (SecondStats& second : seconds) {
        for (double& ms : second.ms)
            ms /= second.ticks;
        for (double& count : second.work)
            count /= second.ticks;
    }
    return seconds;
}

std::vector<SecondStats> run_preset(const LoadedPreset& preset, int threads, double duration) {
    World world = build_world(preset, threads);
    StatsRecorder stats;
    while (world.state().time < duration - 1e-9) {
        const StepReport report = world.step(stats.observer());
        if (!report.ok())
            throw RunError(preset.info.path.string() + ": " + divergence_text(report));
        stats.record(world, report);
    }
    return by_second(stats.ticks());
}

void write_chart(const std::string& preset, const std::vector<SecondStats>& seconds, int threads,
                 const std::filesystem::path& path) {
    BarChart chart{.title = "Time per stage: " + preset,
                   .subtitle = "mean per tick in each simulated second, " +
                               std::to_string(threads) + " threads",
                   .x_title = "simulated second",
                   .y_title = "time per tick [ms]"};
    for (const SecondStats& second : seconds)
        chart.categories.push_back(std::to_string(second.number + 1));
    for (std::size_t s = 0; s < kStageCount; ++s) {
        std::vector<double> values;
        for (const SecondStats& second : seconds)
            values.push_back(second.ms[s]);
        chart.series.emplace_back(kStageNames[s]);
        chart.values.push_back(values);
    }
    write_file(path, chart_svg(chart));
}

void add_rows(const std::string& preset, const std::vector<SecondStats>& seconds, CsvTable& table) {
    for (const SecondStats& second : seconds) {
        std::vector<std::string> cells = {preset, std::to_string(second.number + 1)};
        for (const double ms : second.ms)
            cells.push_back(short_text(ms, 5));
        for (const double count : second.work)
            cells.push_back(short_text(count, 7));
        table.add(cells);
    }
}

CsvTable stages_table() {
    std::vector<std::string> columns = {"preset", "simulated second"};
    for (const std::string_view stage : kStageNames)
        columns.push_back("ms per tick " + std::string(stage));
    for (const CounterColumn& counter : kCounters)
        columns.push_back(std::string(counter.name) + " per tick");
    return CsvTable(columns);
}

}  // namespace

int bench_stages(const BenchOptions& options, std::vector<std::string> presets) {
    if (presets.empty()) presets = built_in_presets();
    CsvTable table = stages_table();
    for (const std::string& name : presets) {
        RunOptions run;
        run.preset = name;
        const LoadedPreset preset = load_run(run);
        const double shot = preset.render.shot.duration;
        const auto seconds =
            run_preset(preset, options.threads, options.quick ? std::min(shot, 3.0) : shot);
        add_rows(name, seconds, table);
        std::string stem = name;
        std::replace(stem.begin(), stem.end(), '/', '_');
        write_chart(name, seconds, options.threads, options.out / ("stages_" + stem + ".svg"));
        for (const SecondStats& second : seconds) {
            double total = 0;
            for (const double ms : second.ms)
                total += ms;
            std::printf(
                "%-20s second %2d %9.3f ms per tick (springs %.3f, fire and coupling "
                "%.3f)\n",
                name.c_str(), second.number + 1, total, second.ms[index_of(Stage::Springs)],
                second.ms[index_of(Stage::Fire)] + second.ms[index_of(Stage::Coupling)]);
        }
        std::fflush(stdout);
    }
    write_file(options.out / "stages.csv", table.text());
    return kOk;
}

}  // namespace ember
