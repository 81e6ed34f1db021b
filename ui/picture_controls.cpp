#include "ui/picture_controls.h"

#include <imgui.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "render/camera.h"

namespace ember {
namespace {

constexpr double kOrbitPerPoint = 0.008;  // [rad]
constexpr double kLampPerPoint = 0.008;   // [rad]
constexpr double kZoomPerNotch = 1.15;    // [1]
constexpr double kZoomPerPoint = 1.005;   // [1]

// What is under the mouse, level with the camera's target, stays there.
void zoom_towards(CameraParams& camera, double factor, const PicturePoint& at,
                  const PictureRect& picture) {
    const double before = camera.distance;
    const CameraParams from = camera;
    zoom(camera, factor);
    const double share = (1 - camera.distance / before) / picture.height;
    CameraParams moved = from;
    pan(moved, share * (at.x - 0.5 * picture.width), share * (0.5 * picture.height - at.y));
    moved.distance = camera.distance;
    camera = moved;
}

}  // namespace

std::optional<PicturePoint> mouse_in(const PictureRect& picture) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantCaptureMouse || !ImGui::IsMousePosValid()) return std::nullopt;
    const PicturePoint at{double(io.MousePos.x) - picture.x, double(io.MousePos.y) - picture.y};
    const bool inside = at.x >= 0 && at.y >= 0 && at.x < picture.width && at.y < picture.height;
    return inside ? std::optional(at) : std::nullopt;
}

void PictureControls::begin_drag(CameraScheme scheme, bool placing) {
    const ImGuiIO& io = ImGui::GetIO();
    for (int button = 0; button < ImGuiMouseButton_COUNT; ++button) {
        if (!io.MouseClicked[button]) continue;
        drag_ = find_drag(scheme, button, io.KeyShift, io.KeyCtrl, io.KeyAlt);
        button_ = button;
        begun_ = true;
        if (placing && button == ImGuiMouseButton_Left) drag_ = Drag::PlaceLighter;
    }
}

std::optional<PictureDrag> PictureControls::update(RenderParams& render, CameraScheme scheme,
                                                   const PictureRect& picture, bool& placing,
                                                   bool taken) {
    const ImGuiIO& io = ImGui::GetIO();
    CameraParams& camera = render.camera;
    const auto over = mouse_in(picture);
    if (over && !taken && !drag_) {
        begin_drag(scheme, placing);
        if (drag_) from_ = *over;
        const double factor = std::pow(kZoomPerNotch, double(io.MouseWheel));
        if (factor != 1 && io.KeyCtrl) zoom_towards(camera, factor, *over, picture);
        if (factor != 1 && !io.KeyCtrl) zoom(camera, factor);
    }
    if (!drag_) return std::nullopt;
    const Drag drag = *drag_;
    const bool ended = !io.MouseDown[button_];
    if (ended) drag_.reset();
    const double dx = double(io.MouseDelta.x), dy = double(io.MouseDelta.y);
    if (drag == Drag::Orbit) orbit(camera, -kOrbitPerPoint * dx, kOrbitPerPoint * dy);
    if (drag == Drag::Pan) pan(camera, -dx / picture.height, dy / picture.height);
    if (drag == Drag::Zoom) zoom(camera, std::pow(kZoomPerPoint, dx - dy));
    double& lamp = render.look.light_azimuth;
    if (drag == Drag::TurnLight)
        lamp = std::remainder(lamp + kLampPerPoint * dx, 2 * std::numbers::pi);
    if (drag == Drag::Orbit || drag == Drag::Pan || drag == Drag::Zoom || drag == Drag::TurnLight)
        return std::nullopt;
    placing = placing && !(drag == Drag::PlaceLighter && ended);
    const PicturePoint at{double(io.MousePos.x) - picture.x, double(io.MousePos.y) - picture.y};
    return PictureDrag{drag, at, from_, std::exchange(begun_, false), ended};
}

}  // namespace ember
