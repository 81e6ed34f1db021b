// Simulates, draws and encodes the pictures of a shot, all three at the same time.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

#include "app/frame_painter.h"

namespace ember {

/// [s] during which each part was at work rather than waiting.
struct PipelineTimes {
    double simulating = 0, drawing = 0, encoding = 0;
};

/// Picture n is drawn while n + 1 is simulated and n - 1 encoded; a few wait in between, so memory
/// is bounded. What is drawn never depends on that. Drawing is done by the calling thread, which
/// owns the GL context.
class ShotPipeline {
  public:
    using Sinks = std::vector<std::unique_ptr<PictureSink>>;
    /// `samples` moments are drawn for each exposure. `done` is told how many pictures are
    /// complete. All must outlive the pipeline.
    ShotPipeline(FrameSource& source, FramePainter& painter, const RenderJob& job, Sinks& sinks,
                 int samples, std::function<void(long)> done);

    /// Looks what is there already. Throws InputError when something else is.
    void skip_existing(const std::vector<PlannedPicture>& pictures);

    /// Returns false when the simulation diverged; what came before is complete. An interrupt ends
    /// it after the picture that is being drawn. Throws what the first part to fail has thrown.
    [[nodiscard]] bool run(const std::vector<PlannedPicture>& pictures, bool overlap);

    [[nodiscard]] PipelineTimes times() const { return times_; }
    [[nodiscard]] long done() const { return done_; }        ///< pictures, with those there already
    [[nodiscard]] long skipped() const { return skipped_; }  ///< of these, drawn by an earlier run

  private:
    struct Exposure;
    struct Drawn;

    [[nodiscard]] std::optional<Exposure> simulate(const PlannedPicture& planned, std::size_t i);
    [[nodiscard]] Drawn draw(const Exposure& exposure);
    void encode(const Drawn& drawn);
    [[nodiscard]] std::vector<PictureSink*> lacking(std::size_t picture) const;
    void overlapped(const std::vector<PlannedPicture>& pictures);
    void one_by_one(const std::vector<PlannedPicture>& pictures);
    void keep(std::exception_ptr error);

    FrameSource& source_;
    FramePainter& painter_;
    const RenderJob& job_;
    Sinks& sinks_;
    int samples_;
    std::function<void(long)> told_;
    std::vector<std::vector<bool>> present_;  ///< per picture, per sink; empty: nothing is
    PipelineTimes times_;
    long done_ = 0, skipped_ = 0;
    std::atomic<bool> diverged_ = false;
    std::mutex mutex_;
    std::exception_ptr error_;  ///< the first
};

}  // namespace ember
