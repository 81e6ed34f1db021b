#include "ui/camera_flight.h"

#include <cmath>
#include <numbers>

namespace ember {

void CameraFlight::begin(const CameraParams& from, const CameraParams& to, double now) {
    from_ = from;
    to_ = to;
    begun_ = now;
    flying_ = true;
}

std::optional<CameraParams> CameraFlight::at(double now) {
    if (!flying_) return std::nullopt;
    const double share = (now - begun_) / kDuration;
    flying_ = share < 1;
    if (!flying_) return to_;
    const double s = share * share * (3 - 2 * share);
    const auto between = [s](double a, double b) { return a + s * (b - a); };
    CameraParams camera = to_;
    camera.target_x = between(from_.target_x, to_.target_x);
    camera.target_y = between(from_.target_y, to_.target_y);
    camera.target_z = between(from_.target_z, to_.target_z);
    // the short way round
    const double turn = std::remainder(to_.azimuth - from_.azimuth, 2 * std::numbers::pi);
    camera.azimuth = from_.azimuth + s * turn;
    camera.elevation = between(from_.elevation, to_.elevation);
    camera.field_of_view = between(from_.field_of_view, to_.field_of_view);
    // what is at the target changes its size evenly
    const auto height = [](const CameraParams& c) {
        return c.distance * std::tan(0.5 * c.field_of_view);
    };
    camera.distance = height(from_) * std::pow(height(to_) / height(from_), s) /
                      std::tan(0.5 * camera.field_of_view);
    return camera;
}

}  // namespace ember
