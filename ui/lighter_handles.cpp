#include "ui/lighter_handles.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "sim/lighter.h"
#include "ui/lighter_placement.h"
#include "ui/theme.h"

namespace ember {
namespace {

constexpr double kSnap = 0.005;                              // [m]
constexpr double kLeastRadius = 0.0005, kMostRadius = 0.05;  // [m]
constexpr float kGrip = 0.45f;                               // [font sizes] around a handle
constexpr float kArm = 2.2f;                                 // [font sizes] from place to height

std::optional<ImVec2> on_screen(const PictureCamera& picture, const Vector3& place) {
    const Eigen::Vector3f p =
        project(picture.camera, place.cast<float>(), static_cast<int>(picture.rect.width),
                static_cast<int>(picture.rect.height));
    if (!(p.z() > 0 && p.z() < 1)) return std::nullopt;
    return ImVec2(p.x() + static_cast<float>(picture.rect.x),
                  p.y() + static_cast<float>(picture.rect.y));
}

bool near(const ImVec2& a, const ImVec2& b, float distance) {
    return std::hypot(a.x - b.x, a.y - b.y) <= distance;
}

double snapped(double length, bool snap) {
    return snap ? std::round(length / kSnap) * kSnap : length;
}

}  // namespace

bool LighterHandles::update(const PictureCamera& picture, Workbench& bench) {
    if (held_) drag(picture, bench);
    const auto lighters = lighters_of(bench.values.params);
    const Snapshot& shot = bench.snapshot();
    const float font = ImGui::GetFontSize(), grip = kGrip * font;
    const auto mouse = mouse_in(picture.rect);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const auto corner = [&](double x, double y) {
        return ImVec2(static_cast<float>(x), static_cast<float>(y));
    };
    const PictureRect& r = picture.rect;
    list.PushClipRect(corner(r.x, r.y), corner(r.x + r.width, r.y + r.height));
    bool on_one = held_.has_value();
    for (std::size_t i = 0; i < lighters.size(); ++i) {
        const Vector3 place = lighter_position(lighters[i], shot.view.time);
        const auto centre = on_screen(picture, place);
        if (!centre) continue;
        const bool edited = i == bench.lighter;
        const bool lit = lighter_lit(lighters[i], shot.view.time, shot.timeline.tick_duration);
        const ImU32 colour = handle_colour(edited, lit);
        const ImVec2 top(centre->x, centre->y - kArm * font),
            side(centre->x + 1.3f * font, centre->y);
        list.AddCircle(*centre, grip, colour, 24, 0.12f * font);
        if (lit) list.AddCircleFilled(*centre, 0.5f * grip, colour, 16);
        if (edited) {
            list.AddLine(ImVec2(centre->x, centre->y - grip), top, colour, 0.1f * font);
            list.AddTriangleFilled(ImVec2(top.x - 0.3f * font, top.y),
                                   ImVec2(top.x + 0.3f * font, top.y),
                                   ImVec2(top.x, top.y - 0.5f * font), colour);
            list.AddLine(ImVec2(centre->x + grip, centre->y), side, colour, 0.1f * font);
            list.AddRectFilled(ImVec2(side.x - 0.2f * font, side.y - 0.2f * font),
                               ImVec2(side.x + 0.2f * font, side.y + 0.2f * font), colour);
        }
        if (!mouse || held_ || ImGui::GetIO().KeyCtrl) continue;
        const ImVec2 at = ImGui::GetIO().MousePos;
        std::optional<Handle> below;
        if (near(at, *centre, 1.3f * grip)) below = Handle::Place;
        if (edited && near(at, top, 1.5f * grip)) below = Handle::Height;
        if (edited && near(at, side, 1.2f * grip)) below = Handle::Radius;
        if (!below) continue;
        on_one = true;
        if (!ImGui::IsMouseClicked(ImGuiMouseButton_Left)) continue;
        bench.lighter = i;
        held_ = Held{*below, lighters[i], *mouse, place};
    }
    list.PopClipRect();
    return on_one;
}

void LighterHandles::drag(const PictureCamera& picture, Workbench& bench) {
    const ImGuiIO& io = ImGui::GetIO();
    const PicturePoint at{double(io.MousePos.x) - picture.rect.x,
                          double(io.MousePos.y) - picture.rect.y};
    const Vector3 moved =
        picture.beside(held_->place, at) - picture.beside(held_->place, held_->from);
    const bool moved_at_all = at.x != held_->from.x || at.y != held_->from.y;
    LighterParams lighter = held_->before;
    Vector3 place = held_->place;
    if (held_->handle == Handle::Place) place += moved;
    if (held_->handle == Handle::Height) place.y() += moved.y();
    if (held_->handle == Handle::Radius) {
        const double right = (at.x - held_->from.x) / picture.rect.height;
        lighter.radius =
            std::clamp(lighter.radius * std::exp2(20 * right), kLeastRadius, kMostRadius);
    } else {
        for (int axis = 0; axis < 3; ++axis)
            place[axis] = snapped(place[axis], io.KeyCtrl);
        move_lighter(lighter, place, true, 0);  // it stays as lit as it is
    }
    if (!io.MouseDown[ImGuiMouseButton_Left]) held_.reset();
    if (moved_at_all) bench.change_lighter(bench.lighter, lighter);
}

}  // namespace ember
