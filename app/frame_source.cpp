#include "app/frame_source.h"

#include <cmath>

namespace ember {
namespace {

constexpr double kSameTime = 1e-9;  // [s]

// a + share (b - a) on the entries that both have.
void blend(std::vector<double>& a, const std::vector<double>& b, double share) {
    for (std::size_t i = 0; i < a.size(); ++i)
        a[i] += share * (b[i] - a[i]);
}

void blend(Vector3Array& a, const Vector3Array& b, double share) {
    blend(a.x, b.x, share);
    blend(a.y, b.y, share);
    blend(a.z, b.z, share);
}

void point_at(const SheetState& state, SheetView& view) {
    view.x = state.position.x, view.y = state.position.y, view.z = state.position.z;
    view.vx = state.velocity.x, view.vy = state.velocity.y, view.vz = state.velocity.z;
    view.temperature = state.temperature;
    view.mass = state.mass;
    view.initial_mass = state.initial_mass;
    view.ignition_time = state.ignition_time;
    view.burnout_time = state.burnout_time;
    view.phase = state.phase;
    view.site = state.site;
    view.quads = state.quads;
    view.crack_x = state.cracks.offset_x, view.crack_z = state.cracks.offset_z;
    view.topology_version = state.topology_version;
}

void point_at(const FireState& fire, ParticleView& view) {
    view = {fire.position.x, fire.position.y,  fire.position.z, fire.velocity.x, fire.velocity.y,
            fire.velocity.z, fire.temperature, fire.birth,      fire.death,      fire.id};
}

}  // namespace

FrameSource::FrameSource(World& world, StageObserver* observer,
                         std::function<void(const StepReport&)> after_step, bool with_springs)
    : world_(world),
      observer_(observer),
      after_step_(std::move(after_step)),
      with_springs_(with_springs) {}

std::vector<std::vector<SpringSegment>> FrameSource::springs() const {
    std::vector<std::vector<SpringSegment>> all(world_.state().sheets.size());
    for (std::size_t s = 0; with_springs_ && s < all.size(); ++s)
        all[s] = world_.springs(s);
    return all;
}

bool FrameSource::step(bool keep_earlier) {
    if (change_) change_(world_);
    has_earlier_ = keep_earlier;
    if (keep_earlier) {
        earlier_ = world_.snapshot();
        earlier_view_ = world_.view();
        earlier_springs_ = springs();
    }
    const StepReport report = world_.step(observer_);
    if (after_step_) after_step_(report);
    return report.ok();
}

bool FrameSource::advance_to(double time) {
    while (world_.state().time + world_.tick_duration() <= time + kSameTime) {
        if (!step(false)) return false;
    }
    return true;
}

bool FrameSource::show(double time, FrameView& frame) {
    if (!advance_to(time)) return false;
    if (time - world_.state().time > kSameTime && !step(true)) return false;
    if (!has_earlier_ || std::abs(time - world_.state().time) <= kSameTime) {
        frame.sheets.clear();
        frame.view = world_.view();
        frame.springs = springs();
        return true;
    }
    interpolate((time - earlier_.time) / world_.tick_duration(), frame);
    return true;
}

void FrameSource::detach(FrameView& frame) const {
    if (!frame.sheets.empty()) return;
    frame.sheets = world_.state().sheets;
    for (std::size_t s = 0; s < frame.sheets.size(); ++s)
        point_at(frame.sheets[s], frame.view.sheets[s]);
    frame.fire = world_.state().fire;
    point_at(frame.fire, frame.view.particles);
}

void FrameSource::interpolate(double share, FrameView& frame) const {
    const std::vector<SheetState>& later = world_.state().sheets;
    frame.view = earlier_view_;
    frame.view.time = earlier_.time + share * world_.tick_duration();
    frame.view.lighters = world_.lighters_at(frame.view.time);
    frame.springs = earlier_springs_;
    frame.sheets = earlier_.sheets;
    for (std::size_t s = 0; s < frame.sheets.size(); ++s) {
        // copies that the later tick has made come after the nodes that both have
        blend(frame.sheets[s].position, later[s].position, share);
        blend(frame.sheets[s].velocity, later[s].velocity, share);
        blend(frame.sheets[s].temperature, later[s].temperature, share);
        point_at(frame.sheets[s], frame.view.sheets[s]);
    }
    frame.fire = earlier_.fire;
    const double dt = share * world_.tick_duration();
    for (std::size_t i = 0; i < frame.fire.size(); ++i) {
        frame.fire.position.set(i, frame.fire.position.at(i) + dt * frame.fire.velocity.at(i));
    }
    point_at(frame.fire, frame.view.particles);
}

}  // namespace ember
