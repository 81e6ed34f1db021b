// Steps a world and shows it at any time: between two ticks, pictures interpolate.
#pragma once

#include <functional>
#include <vector>

#include "sim/world.h"

namespace ember {

/// What a picture shows, with the arrays that its view points into.
struct FrameView {
    WorldView view;
    std::vector<std::vector<SpringSegment>> springs;
    std::vector<SheetState> sheets;  ///< interpolated copies; empty when the view is the world's
    FireState fire;
};

/// Steps `world` forwards as pictures ask for it. The steps never depend on the pictures.
class FrameSource {
  public:
    /// `observer` may be null; `after_step` is called with every report (and may be empty).
    /// Springs are collected only `with_springs`: they are many, and few pictures show them.
    FrameSource(World& world, StageObserver* observer,
                std::function<void(const StepReport&)> after_step, bool with_springs = false);

    /// Has `change` called before every tick from now on: parameters that move, edits that are
    /// replayed. It may apply() and must not step().
    void before_each_tick(std::function<void(World&)> change) { change_ = std::move(change); }

    /// The world at `time` [s], which must not lie before an earlier request. Positions,
    /// velocities and temperatures are interpolated between the neighbouring ticks, everything
    /// else, topology included, is the earlier tick's; particles fly on from there.
    /// Returns false when the simulation diverged; the report has gone to after_step.
    [[nodiscard]] bool show(double time, FrameView& frame);

    /// Makes `frame`, the last that was shown, independent of the world. It may then be moved, not
    /// copied.
    void detach(FrameView& frame) const;

    /// Steps until the next tick would lie beyond `time`. Returns false when it diverged.
    [[nodiscard]] bool advance_to(double time);

  private:
    [[nodiscard]] bool step(bool keep_earlier);
    [[nodiscard]] std::vector<std::vector<SpringSegment>> springs() const;
    void interpolate(double share, FrameView& frame) const;

    World& world_;
    StageObserver* observer_;
    std::function<void(const StepReport&)> after_step_;
    std::function<void(World&)> change_;
    bool with_springs_;
    bool has_earlier_ = false;
    WorldState earlier_;  ///< the tick before the world's, if has_earlier_
    WorldView earlier_view_;
    std::vector<std::vector<SpringSegment>> earlier_springs_;
};

}  // namespace ember
