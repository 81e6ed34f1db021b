#include "app/command_simulate.h"

#include <cmath>
#include <cstdio>
#include <memory>

#include "app/atomic_file.h"
#include "app/diverged.h"
#include "app/exit_code.h"
#include "app/file_pattern.h"
#include "app/frame_list.h"
#include "app/interrupt.h"
#include "app/progress.h"
#include "app/run_options.h"
#include "app/state_ply.h"
#include "app/stats_json.h"

namespace ember {
namespace {

struct SimulateOptions {
    RunOptions run;
    double seconds = -1;
    std::string stats, state, at;
};

// Writes the states that are due at the world's present time.
class StateWriter {
  public:
    StateWriter(const SimulateOptions& options, double end) : pattern_(options.state) {
        if (!options.at.empty()) times_ = parse_times(options.at);
        if (options.at.empty() && !options.state.empty()) times_ = {end};
        numbered_ = times_.size() > 1 || options.state.find('#') != std::string::npos ||
                    options.state.find('%') != std::string::npos;
        name_ = options.state;
    }
    void write_due(const World& world) {
        while (next_ < times_.size() &&
               times_[next_] <= world.state().time + 0.5 * world.tick_duration()) {
            const std::string name = numbered_ ? pattern_.name(static_cast<long>(next_)) : name_;
            write_file(name, state_ply(world.view()));
            ++next_;
        }
    }

  private:
    FilePattern pattern_;
    std::string name_;
    std::vector<double> times_;
    std::size_t next_ = 0;
    bool numbered_ = false;
};

int simulate(const SimulateOptions& options) {
    LoadedPreset preset = load(options.run);
    if (!options.at.empty() && options.state.empty()) {
        throw InputError("--at: says when states are written; --state FILE.ply must say where");
    }
    const double seconds = options.seconds >= 0 ? options.seconds : preset.render.shot.duration;
    StateWriter states(options, seconds);
    World world = make_world(preset.params, options.run.thread_count());
    StageClock clock;
    RunStats stats(options.run.preset, world);
    const auto ticks = static_cast<long>(std::lround(seconds / world.tick_duration()));
    Progress progress("ticks", ticks, options.run.quiet);
    states.write_due(world);
    for (long tick = 1; tick <= ticks && interrupt_signal() == 0; ++tick) {
        const StepReport report = world.step(&clock);
        if (!report.ok()) {
            progress.finish();
            throw RunError(diverged_text(report));
        }
        stats.record(world, report, clock);
        states.write_due(world);
        progress.update(tick);
    }
    progress.finish();
    if (!options.stats.empty()) write_file(options.stats, stats.text(world));
    if (!options.run.quiet) std::fputs(stats.summary(world).c_str(), stdout);
    return interrupt_signal() != 0 ? 128 + interrupt_signal() : kOk;
}

}  // namespace

void declare_simulate(CLI::App& program, Command& command) {
    CLI::App* sub = program.add_subcommand("simulate", "Simulate without rendering");
    const auto options = std::make_shared<SimulateOptions>();
    options->run.declare(*sub);
    sub->add_option("--seconds", options->seconds, "Simulated time; default: the preset's shot")
        ->check(CLI::Range(0.0, 86400.0));
    sub->add_option("--stats", options->stats, "Write statistics of every tick as JSON");
    sub->add_option("--state", options->state, "Write the state as PLY, at the end or at --at");
    sub->add_option("--at", options->at, "Times of states [s]: 0.5,1,2");
    sub->callback([&command, options] { command = [options] { return simulate(*options); }; });
}

}  // namespace ember
