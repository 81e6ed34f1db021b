#include "app/shot.h"

#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "app/exit_code.h"
#include "app/interrupt.h"
#include "app/preset_io/atomic_file.h"
#include "app/shot_record.h"
#include "sim/param_table.h"

namespace ember {
namespace {

constexpr double kWorthSaying = 50e6;  // [bytes]

std::string megabytes(double bytes) {
    char text[32];
    std::snprintf(text, sizeof text, bytes < 1e10 ? "%.0f MB" : "%.1f GB",
                  bytes / (bytes < 1e10 ? 1e6 : 1e9));
    return text;
}

double largest_memory() {  // [bytes]
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

}  // namespace

Shot::Shot(const RenderOptions& options, const RenderJob& job, World& world,
           const std::vector<PlannedPicture>& pictures, const OpenSink& open)
    : options_(options),
      job_(job),
      world_(world),
      pictures_(pictures),
      painter_(options),
      source_(
          world, options.stats.empty() ? nullptr : stats_.observer(),
          [this](const StepReport& report) { note(report); },
          needs_springs(job.preset.render.view.mode)),
      progress_("pictures", static_cast<long>(pictures.size()),
                Progress::style_of(options.progress, options.run.quiet)),
      pipeline_(source_, painter_, job, sinks_, options.blur_samples,
                [this](long done) { progress_.update(done); }) {
    if (job.keys.move_simulation())
        source_.before_each_tick([this](World& moved) { job_.keys.apply(moved); });
    const PictureFormat format{job.size.width,
                               job.size.height,
                               job.preset.render.shot.fps,
                               static_cast<long>(pictures.size()),
                               shot_text(options, job, painter_.description()),
                               options.grid};
    for (const std::string& output : options.outputs)
        sinks_.push_back(open(output, format));
    if (!options.run.verbose) return;
    std::fprintf(stderr, "%s: %s\n", painter_.backend().c_str(), painter_.description().c_str());
}

void Shot::note(const StepReport& report) {
    last_report_ = report;
    if (!options_.stats.empty() && report.ok()) stats_.record(world_, report);
}

int Shot::draw() {
    if (options_.skip_existing) pipeline_.skip_existing(pictures_);
    if (!options_.run.quiet) say_what_it_takes();
    bool good = pipeline_.run(pictures_, !options_.serial);
    const double seconds = progress_.seconds();
    progress_.finish();
    if (good && is_whole() && pipeline_.skipped() == 0 && interrupt_signal() == 0)
        good = source_.advance_to(options_.start + job_.preset.render.shot.duration);
    finish(seconds);
    if (!good) throw RunError(divergence_text(last_report_));
    return interrupt_signal() == 0 ? kOk : 128 + interrupt_signal();
}

void Shot::say_what_it_takes() const {
    for (const std::string& output : options_.outputs) {
        const double bytes =
            static_cast<double>(pictures_.size()) *
            estimated_bytes(output_kind(output), job_.size.width, job_.size.height);
        if (output == "-" || bytes < kWorthSaying) continue;
        std::error_code error;
        const std::filesystem::path folder = std::filesystem::absolute(output).parent_path();
        const auto space = std::filesystem::space(folder, error);
        const auto left = static_cast<double>(space.available);
        std::fprintf(stderr, "%s: about %s", output.c_str(), megabytes(bytes).c_str());
        if (!error) std::fprintf(stderr, "; %s are free", megabytes(left).c_str());
        std::fprintf(stderr, "%s\n", !error && left < bytes ? ": warning: that may not do" : "");
    }
    if (pipeline_.skipped() > 0)
        std::fprintf(stderr, "%ld pictures are there already\n", pipeline_.skipped());
}

void Shot::finish(double seconds) {
    for (const auto& sink : sinks_) {
        sink->finish();
        if (!options_.run.quiet) std::fprintf(stderr, "%s\n", sink->where().c_str());
    }
    if (!options_.stats.empty()) write_file(options_.stats, stats_.json(world_, job_.preset));
    if (options_.run.quiet) return;
    if (interrupt_signal() != 0) say_how_to_go_on();
    const PipelineTimes times = pipeline_.times();
    std::fprintf(stderr,
                 "%.1f s: simulating %.1f s, drawing %.1f s, encoding %.1f s; %s of memory\n",
                 seconds, times.simulating, times.drawing, times.encoding,
                 megabytes(largest_memory()).c_str());
    if (pipeline_.skipped() == 0) std::fprintf(stderr, "%s\n", labelled_hash(world_).c_str());
}

void Shot::say_how_to_go_on() const {
    const bool files = std::any_of(options_.outputs.begin(), options_.outputs.end(),
                                   [](const std::string& output) {
                                       const OutputKind kind = output_kind(output);
                                       return kind == OutputKind::Png || kind == OutputKind::Exr;
                                   });
    std::fprintf(stderr, "interrupted after %ld of %zu pictures; %s\n", pipeline_.done(),
                 pictures_.size(),
                 files ? "to go on, give the same command with --skip-existing"
                       : "a film cannot be continued, but with a second output, -o "
                         "frame_####.png, it can be");
}

}  // namespace ember
