// A shot from its preset to its files.
#pragma once

#include "app/shot_pipeline.h"
#include "app/stats_json.h"

namespace ember {

using OpenSink = std::function<std::unique_ptr<PictureSink>(const std::string& output,
                                                            const PictureFormat& format)>;

class Shot {
  public:
    /// Opens all outputs by `open`. The arguments must outlive the shot.
    Shot(const RenderOptions& options, const RenderJob& job, World& world,
         const std::vector<PlannedPicture>& pictures, const OpenSink& open);

    /// Draws all and completes the files; returns the exit code. What has been drawn before an
    /// interrupt or a failed simulation is complete. Throws RunError when the simulation diverged.
    int draw();

  private:
    void note(const StepReport& report);
    void say_what_it_takes() const;
    void finish(double seconds);
    void say_how_to_go_on() const;
    [[nodiscard]] bool is_whole() const { return options_.frames.empty() && options_.at.empty(); }

    const RenderOptions& options_;
    const RenderJob& job_;
    World& world_;
    const std::vector<PlannedPicture>& pictures_;
    FramePainter painter_;
    StatsRecorder stats_;
    FrameSource source_;
    ShotPipeline::Sinks sinks_;
    Progress progress_;
    ShotPipeline pipeline_;
    StepReport last_report_;
};

}  // namespace ember
