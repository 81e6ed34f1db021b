// emberleaf simulate: the simulation alone.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <optional>

#include "app/checkpoint.h"
#include "app/commands.h"
#include "app/exit_code.h"
#include "app/file_pattern.h"
#include "app/frame_list.h"
#include "app/frame_source.h"
#include "app/hash_log.h"
#include "app/interrupt.h"
#include "app/preset_io/atomic_file.h"
#include "app/progress.h"
#include "app/run_options.h"
#include "app/state_ply.h"
#include "app/stats_json.h"

namespace ember {
namespace {

struct SimulateOptions {
    RunOptions run;
    double seconds = -1;  // [s]; negative: the preset's shot
    std::string stats, state, save, resume, at, hashes, verify, progress = "auto";
};

// The times of the states to write; the end unless others are asked for.
std::vector<double> state_times(const SimulateOptions& options, double end) {
    if (options.state.empty() && options.save.empty()) {
        if (!options.at.empty()) throw InputError("--at: error: needs --state or --save");
        return {};
    }
    if (options.at.empty()) return {end};
    std::vector<double> times = parse_times(options.at);
    if (times.back() > end) throw InputError("--at: error: a time lies after --seconds");
    return times;
}

void print_summary(const World& world, const StatsRecorder& stats) {
    const PhaseCounts nodes = count_phases(world.state());
    const auto ms = stats.mean_ms();
    double total = 0;
    for (const double stage : ms)
        total += stage;
    std::printf("simulated: %g s in %llu ticks, %.3f ms per tick\n", world.state().time,
                static_cast<unsigned long long>(world.state().tick), total);
    std::printf("ms per stage:");
    for (std::size_t s = 0; s < kStageCount; ++s) {
        std::printf(" %s %.3f", std::string(kStageNames[s]).c_str(), ms[s]);
    }
    std::printf("\nnodes: %lld unburnt, %lld burning, %lld burnt out\n",
                static_cast<long long>(nodes.unburnt), static_cast<long long>(nodes.burning),
                static_cast<long long>(nodes.burnt_out));
    for (const int percent : {10, 50, 90}) {
        const double time = stats.burnt_out_time(0.01 * percent);
        if (std::isfinite(time)) std::printf("%d %% burnt out at %.2f s\n", percent, time);
    }
    std::printf("cuts: %lld, ticks retried: %lld\n",
                static_cast<long long>(world.state().totals.cuts),
                static_cast<long long>(world.state().totals.retries));
}

// A run while it goes on.
class Run {
  public:
    Run(const SimulateOptions& options, const LoadedPreset& preset, World& world, long ticks,
        const std::optional<HashLog>& expected)
        : options_(options),
          preset_(preset),
          world_(world),
          ticks_(ticks),
          expected_(expected),
          hashes_(world),
          progress_("ticks", ticks_, Progress::style_of(options.progress, options.run.quiet)),
          source_(world, stats_.observer(), [this](const StepReport& r) { note(r); }) {}

    int go(const std::vector<double>& times) {
        note_hash();
        bool good = true;
        for (std::size_t i = 0; good && i < times.size() && interrupt_signal() == 0; ++i) {
            good = advance_to(times[i]) && write_state(i, times);
        }
        good = good && advance_to(static_cast<double>(ticks_) * world_.tick_duration());
        progress_.finish();
        if (!options_.stats.empty()) write_file(options_.stats, stats_.json(world_, preset_));
        if (!options_.hashes.empty()) write_file(options_.hashes, hashes_.text());
        if (!difference_.empty()) {
            std::fprintf(stderr, "%s\n", difference_.c_str());
            return kComparisonFailed;
        }
        if (!good) throw RunError(divergence_text(last_report_));
        if (!options_.run.quiet) print_summary(world_, stats_);
        std::printf("%s\n", labelled_hash(world_).c_str());
        return interrupt_signal() == 0 ? kOk : 128 + interrupt_signal();
    }

  private:
    // tick by tick, so that an interrupt acts at once
    bool advance_to(double time) {
        bool good = true;
        while (good && difference_.empty() && interrupt_signal() == 0 &&
               world_.state().time + world_.tick_duration() < time + 1e-9) {
            good = source_.advance_to(world_.state().time + world_.tick_duration());
        }
        return good;
    }

    bool write_state(std::size_t number, const std::vector<double>& times) {
        if (interrupt_signal() != 0 || !difference_.empty()) return true;
        if (!options_.save.empty()) {
            const FilePattern pattern(options_.save, times.size() > 1);
            save_checkpoint(pattern.name(static_cast<long>(number)), world_, preset_);
        }
        if (options_.state.empty()) return true;
        FrameView frame;
        if (!source_.show(times[number], frame)) return false;
        const FilePattern pattern(options_.state, times.size() > 1);
        write_file(pattern.name(static_cast<long>(number)), state_ply(frame.view));
        return true;
    }

    void note(const StepReport& report) {
        last_report_ = report;
        if (report.ok()) {
            stats_.record(world_, report);
            note_hash();
        }
        progress_.update(static_cast<long>(world_.state().tick));
    }

    void note_hash() {
        if (!options_.hashes.empty()) hashes_.record(world_);
        if (expected_ && difference_.empty()) difference_ = expected_->difference(world_);
    }

    const SimulateOptions& options_;
    const LoadedPreset& preset_;
    World& world_;
    long ticks_;
    const std::optional<HashLog>& expected_;  // by --verify
    HashLog hashes_;
    std::string difference_;  // to what is expected, at the first tick where there is one
    Progress progress_;
    StatsRecorder stats_;
    FrameSource source_;
    StepReport last_report_;
};

// As long as --seconds says, or else the hashes to compare with, or else the preset's shot.
double seconds_of(const SimulateOptions& options, const LoadedPreset& preset,
                  const std::optional<HashLog>& expected) {
    if (options.seconds >= 0) return options.seconds;
    if (!expected) return preset.render.shot.duration;
    return static_cast<double>(expected->last_tick()) / preset.params.numerics.tick_rate;
}

int run_simulate(const SimulateOptions& options) {
    const LoadedPreset preset = load_run(options.run);
    std::optional<HashLog> expected;
    if (!options.verify.empty()) expected.emplace(std::filesystem::path(options.verify));
    const double seconds = seconds_of(options, preset, expected);
    const std::vector<double> times = state_times(options, seconds);
    // whole ticks, so that the last state and its hash never depend on what is written when
    const auto ticks =
        static_cast<long>(std::ceil(seconds * preset.params.numerics.tick_rate - 1e-6));
    for (const std::string& output : {options.state, options.save}) {
        if (!output.empty()) static_cast<void>(FilePattern(output));
    }
    World world = build_world(preset, options.run.threads);
    if (!options.resume.empty()) load_checkpoint(options.resume, world, preset);
    if (!times.empty() && times.front() + 1e-9 < world.state().time)
        throw InputError("--at: error: a time lies before that of --resume");
    watch_for_interrupts();
    return Run(options, preset, world, ticks, expected).go(times);
}

}  // namespace

void add_simulate_command(CLI::App& command, Task& task) {
    const auto options = std::make_shared<SimulateOptions>();
    add_run_options(command, options->run);
    command.add_option("--seconds", options->seconds, "how long; default: the preset's shot")
        ->check(CLI::Range(0.0, 86400.0))
        ->type_name("S");
    command.add_option("--stats", options->stats, "write statistics of every tick as JSON")
        ->type_name("FILE");
    command.add_option("--state", options->state, "write the state as PLY: end.ply, out_####.ply")
        ->type_name("FILE");
    command.add_option("--save", options->save, "save the simulation, to go on with it: end.state")
        ->type_name("FILE");
    command.add_option("--resume", options->resume, "begin with what --save has saved")
        ->type_name("FILE");
    command
        .add_option("--hashes", options->hashes, "write the state hash of every tick, one a line")
        ->type_name("FILE");
    command
        .add_option("--verify", options->verify,
                    "compare with what --hashes has written; exit code 3 at the first difference")
        ->type_name("FILE");
    command.add_option("--at", options->at, "when, for --state and --save; default: the end")
        ->type_name("SECONDS");
    command.add_option("--progress", options->progress, "on stderr")
        ->check(CLI::IsMember({"auto", "json", "none"}))
        ->type_name("auto|json|none");
    command.callback([options, &task] { task = [options] { return run_simulate(*options); }; });
}

}  // namespace ember
