#include "ui/picture_controls.h"

#include <imgui.h>

#include <cmath>
#include <utility>

#include "render/camera.h"

namespace ember {
namespace {

constexpr double kOrbitPerPoint = 0.008;  // [rad]
constexpr double kZoomPerNotch = 1.15;    // [1]
constexpr double kZoomPerPoint = 1.005;   // [1]

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

std::optional<PictureDrag> PictureControls::update(CameraParams& camera, CameraScheme scheme,
                                                   const PictureRect& picture, bool& placing,
                                                   bool taken) {
    const ImGuiIO& io = ImGui::GetIO();
    const auto over = mouse_in(picture);
    if (over && !taken && !drag_) {
        begin_drag(scheme, placing);
        if (drag_) from_ = *over;
        if (io.MouseWheel != 0) zoom(camera, std::pow(kZoomPerNotch, double(io.MouseWheel)));
    }
    if (!drag_) return std::nullopt;
    const Drag drag = *drag_;
    const bool ended = !io.MouseDown[button_];
    if (ended) drag_.reset();
    const double dx = double(io.MouseDelta.x), dy = double(io.MouseDelta.y);
    if (drag == Drag::Orbit) orbit(camera, -kOrbitPerPoint * dx, kOrbitPerPoint * dy);
    if (drag == Drag::Pan) pan(camera, -dx / picture.height, dy / picture.height);
    if (drag == Drag::Zoom) zoom(camera, std::pow(kZoomPerPoint, dx - dy));
    if (drag == Drag::Orbit || drag == Drag::Pan || drag == Drag::Zoom) return std::nullopt;
    placing = placing && !(drag == Drag::PlaceLighter && ended);
    const PicturePoint at{double(io.MousePos.x) - picture.x, double(io.MousePos.y) - picture.y};
    return PictureDrag{drag, at, from_, std::exchange(begun_, false), ended};
}

}  // namespace ember
