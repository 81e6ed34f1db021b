// The orbit camera: pure mathematics, no GL.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>

#include "render/view_params.h"

namespace ember {

struct Camera {
    Eigen::Vector3f eye;         ///< [m]
    Eigen::Matrix4f view;        ///< view-From-world
    Eigen::Matrix4f projection;  ///< clip-From-view
    float tan_half_fov = 0;      ///< [1] vertical
};

[[nodiscard]] Camera make_camera(const CameraParams& params, int width, int height);

/// Height [m] of what the picture shows at the distance of the target.
[[nodiscard]] double metres_high(const CameraParams& params);

/// World point [m] to pixels from the top left corner (x, y) and depth in (0, 1) between the near
/// and far plane; a depth outside means that the point is not in front of the camera.
[[nodiscard]] Eigen::Vector3f project(const Camera& camera, const Eigen::Vector3f& point, int width,
                                      int height);

/// Whether a sphere [m] is at least partly in the picture.
[[nodiscard]] bool sees(const Camera& camera, const Eigen::Vector3f& centre, float radius);

/// A ray through pixel (x, y): its direction in the world [1], from camera.eye.
[[nodiscard]] Eigen::Vector3f ray_through(const Camera& camera, double x, double y, int width,
                                          int height);

/// A place to look from, relative to where a preset's camera stands.
struct CameraView {
    std::string_view name;
    double azimuth, elevation;  ///< [rad]
    double closer;              ///< [1] the preset's distance is divided by it
};

/// front, three_quarter, side, back, top, low, close; nullptr when there is none of that name.
[[nodiscard]] const CameraView* find_camera_view(std::string_view name);
/// All names, for people.
[[nodiscard]] std::string camera_view_names();
/// Keeps target and angle of view.
void look_from(CameraParams& params, const CameraView& view);

/// Turns the camera around its target by mouse movements [rad].
void orbit(CameraParams& params, double to_the_right, double upwards);
/// Moves target and camera in the picture plane by shares of the picture's height.
void pan(CameraParams& params, double to_the_right, double upwards);
/// Changes the angle of view [rad] and the distance with it, so that what is at the target keeps
/// its size; as far as the distance may go.
void change_lens(CameraParams& params, double field_of_view);
/// Divides the distance by `factor`.
void zoom(CameraParams& params, double factor);

}  // namespace ember
