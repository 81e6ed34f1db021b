#include "render/camera.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace ember {
namespace {

constexpr double kSteepest = 1.55;                   // [rad] just short of looking straight down
constexpr double kNearest = 0.02, kFarthest = 20.0;  // [m]

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr CameraView kViews[] = {
    {"front", 0.0, 5 * kDegree, 1.0},         {"three_quarter", 35 * kDegree, 15 * kDegree, 1.0},
    {"side", 80 * kDegree, 5 * kDegree, 1.0}, {"back", 180 * kDegree, 5 * kDegree, 1.0},
    {"top", 0.0, 75 * kDegree, 1.0},          {"low", 25 * kDegree, -8 * kDegree, 1.0},
    {"close", 20 * kDegree, 6 * kDegree, 2.2}};

struct Frame3 {
    Eigen::Vector3d forward, right, up;
};

Frame3 frame_of(const CameraParams& p) {
    const double ce = std::cos(p.elevation), se = std::sin(p.elevation);
    // azimuth 0 looks along -z; positive azimuth moves the camera to the right
    const Eigen::Vector3d forward(-std::sin(p.azimuth) * ce, -se, -std::cos(p.azimuth) * ce);
    const Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitY()).normalized();
    return {forward, right, right.cross(forward)};
}

}  // namespace

Camera make_camera(const CameraParams& p, int width, int height) {
    const Frame3 f = frame_of(p);
    const Eigen::Vector3d target(p.target_x, p.target_y, p.target_z);
    const Eigen::Vector3d eye = target - p.distance * f.forward;
    Camera camera;
    camera.eye = eye.cast<float>();
    Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
    view.block<1, 3>(0, 0) = f.right.transpose();
    view.block<1, 3>(1, 0) = f.up.transpose();
    view.block<1, 3>(2, 0) = -f.forward.transpose();
    view.block<3, 1>(0, 3) = -view.block<3, 3>(0, 0) * eye;
    camera.view = view.cast<float>();
    const double tan_half = std::tan(0.5 * p.field_of_view);
    const double near_plane = 0.05 * p.distance, far_plane = p.distance + 10.0;
    Eigen::Matrix4d projection = Eigen::Matrix4d::Zero();
    projection(0, 0) = height / (tan_half * width);
    projection(1, 1) = 1.0 / tan_half;
    projection(2, 2) = -(far_plane + near_plane) / (far_plane - near_plane);
    projection(2, 3) = -2.0 * far_plane * near_plane / (far_plane - near_plane);
    projection(3, 2) = -1.0;
    camera.projection = projection.cast<float>();
    camera.tan_half_fov = static_cast<float>(tan_half);
    return camera;
}

double metres_high(const CameraParams& params) {
    return 2 * std::tan(0.5 * params.field_of_view) * params.distance;
}

Eigen::Vector3f project(const Camera& camera, const Eigen::Vector3f& point, int width, int height) {
    const Eigen::Vector4f clip = camera.projection * (camera.view * point.homogeneous());
    if (!(clip.w() > 0)) return {0, 0, -1};
    const Eigen::Vector3f ndc = clip.head<3>() / clip.w();
    return {(ndc.x() * 0.5f + 0.5f) * static_cast<float>(width),
            (0.5f - ndc.y() * 0.5f) * static_cast<float>(height), ndc.z() * 0.5f + 0.5f};
}

bool sees(const Camera& camera, const Eigen::Vector3f& centre, float radius) {
    const Eigen::Vector3f at = (camera.view * centre.homogeneous()).head<3>();
    const float high = camera.tan_half_fov;
    const float wide = high * camera.projection(1, 1) / camera.projection(0, 0);
    // distance from the planes that bound the picture
    const auto within = [&](float offset, float slope) {
        return std::abs(offset) + at.z() * slope < radius * std::sqrt(1.0f + slope * slope);
    };
    return at.z() < radius && within(at.x(), wide) && within(at.y(), high);
}

Eigen::Vector3f ray_through(const Camera& camera, double x, double y, int width, int height) {
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    const Eigen::Vector3f in_view(
        (2.0f * static_cast<float>(x / width) - 1.0f) * camera.tan_half_fov * aspect,
        (1.0f - 2.0f * static_cast<float>(y / height)) * camera.tan_half_fov, -1.0f);
    const Eigen::Matrix3f rotation = camera.view.block<3, 3>(0, 0);
    return (rotation.transpose() * in_view).normalized();
}

const CameraView* find_camera_view(std::string_view name) {
    const auto* found = std::find_if(std::begin(kViews), std::end(kViews),
                                     [&](const CameraView& view) { return view.name == name; });
    return found == std::end(kViews) ? nullptr : found;
}

std::string camera_view_names() {
    std::string names;
    for (const CameraView& view : kViews)
        names += (names.empty() ? "" : ", ") + std::string(view.name);
    return names;
}

void look_from(CameraParams& params, const CameraView& view) {
    params.azimuth = view.azimuth;
    params.elevation = view.elevation;
    zoom(params, view.closer);
}

void orbit(CameraParams& params, double to_the_right, double upwards) {
    params.azimuth = std::remainder(params.azimuth + to_the_right, 2.0 * std::numbers::pi);
    params.elevation = std::clamp(params.elevation + upwards, -kSteepest, kSteepest);
}

void pan(CameraParams& params, double to_the_right, double upwards) {
    const Frame3 f = frame_of(params);
    const double height = metres_high(params);
    const Eigen::Vector3d move = height * (to_the_right * f.right + upwards * f.up);
    params.target_x += move.x();
    params.target_y += move.y();
    params.target_z += move.z();
}

void change_lens(CameraParams& params, double field_of_view) {
    const double half_height = params.distance * std::tan(0.5 * params.field_of_view);
    params.distance = std::clamp(half_height / std::tan(0.5 * field_of_view), kNearest, kFarthest);
    params.field_of_view = 2 * std::atan(half_height / params.distance);
}

void zoom(CameraParams& params, double factor) {
    params.distance = std::clamp(params.distance / factor, kNearest, kFarthest);
}

}  // namespace ember
