#include "ui/picture_controls.h"

#include <imgui.h>

#include <cmath>

#include "render/camera.h"

namespace ember {
namespace {

constexpr double kOrbitPerPoint = 0.008;  // [rad]
constexpr double kZoomPerNotch = 1.15;    // [1]

}  // namespace

void PictureControls::begin_drag(bool placing) {
    const ImGuiIO& io = ImGui::GetIO();
    for (int button = 0; button < ImGuiMouseButton_COUNT; ++button) {
        if (!io.MouseClicked[button]) continue;
        drag_ = find_drag(button, io.KeyShift, io.KeyCtrl);
        button_ = button;
        if (placing && button == ImGuiMouseButton_Left) drag_ = Drag::PlaceLighter;
    }
}

std::optional<PicturePoint> PictureControls::update(CameraParams& camera, double height,
                                                    bool& placing) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!io.WantCaptureMouse) {
        begin_drag(placing);
        if (io.MouseWheel != 0) zoom(camera, std::pow(kZoomPerNotch, double(io.MouseWheel)));
    }
    if (!drag_) return std::nullopt;
    const Drag drag = *drag_;
    if (!io.MouseDown[button_]) drag_.reset();
    const double dx = double(io.MouseDelta.x), dy = double(io.MouseDelta.y);
    if (drag == Drag::Orbit) orbit(camera, -kOrbitPerPoint * dx, kOrbitPerPoint * dy);
    if (drag == Drag::Pan) pan(camera, -dx / height, dy / height);
    if (drag != Drag::PlaceLighter) return std::nullopt;
    placing = placing && drag_.has_value();
    return PicturePoint{double(io.MousePos.x), double(io.MousePos.y)};
}

}  // namespace ember
