// The orbit camera, without GL.
#include <gtest/gtest.h>

#include <cmath>

#include "render/camera.h"

namespace ember {
namespace {

using Eigen::Vector3f;

constexpr int kWidth = 960, kHeight = 540;

CameraParams straight() {
    CameraParams p;
    p.target_x = 0.1, p.target_y = 0.3, p.target_z = -0.2;
    p.azimuth = p.elevation = 0;
    return p;
}

Vector3f target_of(const CameraParams& p) {
    return Eigen::Vector3d(p.target_x, p.target_y, p.target_z).cast<float>();
}

Vector3f seen(const CameraParams& p, const Vector3f& point) {
    return project(make_camera(p, kWidth, kHeight), point, kWidth, kHeight);
}

TEST(Camera, TheTargetIsInTheMiddleFromEverySide) {
    for (const double azimuth : {-3.0, -1.0, 0.0, 0.4, 2.0}) {
        for (const double elevation : {-1.5, -0.3, 0.0, 0.8, 1.5}) {
            CameraParams p = straight();
            p.azimuth = azimuth, p.elevation = elevation;
            const Vector3f pixel = seen(p, target_of(p));
            EXPECT_NEAR(pixel.x(), kWidth / 2, 1e-2);
            EXPECT_NEAR(pixel.y(), kHeight / 2, 1e-2);
        }
    }
}

TEST(Camera, AzimuthZeroLooksAlongMinusZWithXToTheRightAndYUp) {
    const CameraParams p = straight();
    const Camera camera = make_camera(p, kWidth, kHeight);
    EXPECT_NEAR((camera.eye - target_of(p) - Vector3f(0, 0, 0.78f)).norm(), 0, 1e-6);
    EXPECT_GT(seen(p, target_of(p) + Vector3f(0.1f, 0, 0)).x(), kWidth / 2 + 10);
    EXPECT_LT(seen(p, target_of(p) + Vector3f(0, 0.1f, 0)).y(), kHeight / 2 - 10);
}

TEST(Camera, PositiveAzimuthStandsToTheRightAndPositiveElevationAbove) {
    CameraParams p = straight();
    p.azimuth = 0.5;
    EXPECT_NEAR(make_camera(p, 1, 1).eye.x() - target_of(p).x(), p.distance * std::sin(0.5), 1e-6);
    p = straight();
    p.elevation = 0.5;
    EXPECT_NEAR(make_camera(p, 1, 1).eye.y() - target_of(p).y(), p.distance * std::sin(0.5), 1e-6);
}

TEST(Camera, TheVerticalFieldOfViewFillsTheHeightAndPixelsAreSquare) {
    const CameraParams p = straight();
    const auto half = static_cast<float>(p.distance * std::tan(0.5 * p.field_of_view));
    EXPECT_NEAR(seen(p, target_of(p) + Vector3f(0, half, 0)).y(), 0, 1e-2);
    EXPECT_NEAR(seen(p, target_of(p) - Vector3f(0, half, 0)).y(), kHeight, 1e-2);
    EXPECT_NEAR(seen(p, target_of(p) + Vector3f(half, 0, 0)).x(), (kWidth + kHeight) / 2, 1e-2);
}

TEST(Camera, DepthGrowsWithDistanceAndNothingBehindTheEyeIsInFront) {
    const CameraParams p = straight();
    const Vector3f towards(0, 0, 1);
    const float near_depth = seen(p, target_of(p) + 0.3f * towards).z();
    const float far_depth = seen(p, target_of(p) - 0.3f * towards).z();
    EXPECT_GT(near_depth, 0);
    EXPECT_LT(near_depth, far_depth);
    EXPECT_LT(far_depth, 1);
    const float behind = seen(p, target_of(p) + 2.0f * towards).z();
    EXPECT_TRUE(behind < 0 || behind > 1) << behind;
}

TEST(Camera, TheRayThroughAProjectedPointMeetsThePoint) {
    CameraParams p = straight();
    p.azimuth = 0.7, p.elevation = 0.3;
    const Camera camera = make_camera(p, kWidth, kHeight);
    for (const Vector3f& offset :
         {Vector3f(0.1f, 0.05f, 0.1f), Vector3f(-0.2f, 0.1f, 0), Vector3f(0, -0.15f, -0.3f)}) {
        const Vector3f point = target_of(p) + offset;
        const Vector3f pixel = project(camera, point, kWidth, kHeight);
        const Vector3f ray = ray_through(camera, pixel.x(), pixel.y(), kWidth, kHeight);
        EXPECT_NEAR(ray.norm(), 1, 1e-5);
        EXPECT_NEAR((point - camera.eye).normalized().dot(ray), 1, 1e-6);
        EXPECT_NEAR(((point - camera.eye).norm() * ray + camera.eye - point).norm(), 0, 1e-4);
    }
}

TEST(Camera, OrbitKeepsTheDistanceComesRoundAndStopsShortOfThePoles) {
    CameraParams p = straight();
    for (int i = 0; i < 8; ++i) {
        orbit(p, 2.0 * 3.141592653589793 / 8, 0.01);
        const float distance = (make_camera(p, kWidth, kHeight).eye - target_of(p)).norm();
        EXPECT_NEAR(distance, p.distance, 1e-5);
        EXPECT_LE(std::abs(p.azimuth), 3.1416);
    }
    EXPECT_NEAR(p.azimuth, 0, 1e-12);
    EXPECT_NEAR(p.elevation, 0.08, 1e-12);
    orbit(p, 0, 10);
    EXPECT_LT(p.elevation, 1.5707);
    orbit(p, 0, -20);
    EXPECT_GT(p.elevation, -1.5707);
    EXPECT_TRUE(make_camera(p, kWidth, kHeight).view.allFinite());
}

TEST(Camera, PanMovesByPictureHeightsAndKeepsTheDirection) {
    CameraParams p = straight();
    p.azimuth = 0.9, p.elevation = 0.4;
    const Vector3f before = target_of(p);
    pan(p, 0.25, 0.125);
    const Vector3f pixel =
        seen(p, before);  // the camera went right and up, the point left and down
    EXPECT_NEAR(pixel.x(), kWidth / 2 - 0.25 * kHeight, 0.05);
    EXPECT_NEAR(pixel.y(), kHeight / 2 + 0.125 * kHeight, 0.05);
    EXPECT_EQ(p.azimuth, 0.9);
    EXPECT_EQ(p.distance, straight().distance);
}

TEST(Camera, ZoomDividesTheDistanceWithinBounds) {
    CameraParams p = straight();
    zoom(p, 2);
    EXPECT_DOUBLE_EQ(p.distance, straight().distance / 2);
    zoom(p, 1e9);
    EXPECT_GT(p.distance, 0);
    zoom(p, 1e-9);
    EXPECT_LE(p.distance, 20.0);
}

TEST(Camera, AnotherLensKeepsTheSizeOfWhatIsAtTheTarget) {
    const CameraParams before = straight();
    const Vector3f point = target_of(before) + Vector3f(0.08f, 0.05f, 0);
    const Vector3f nearer = target_of(before) + Vector3f(0.08f, 0.05f, 0.1f);
    CameraParams p = before;
    change_lens(p, 0.05);
    EXPECT_NEAR(p.field_of_view, 0.05, 1e-12);
    EXPECT_NEAR((seen(p, point) - seen(before, point)).head<2>().norm(), 0, 0.05);
    EXPECT_LT((seen(p, nearer) - seen(p, point)).head<2>().norm(),
              0.1f * (seen(before, nearer) - seen(before, point)).head<2>().norm());
    change_lens(p, 1e-6);
    EXPECT_LE(p.distance, 20.0) << "not out of the world";
    EXPECT_NEAR((seen(p, point) - seen(before, point)).head<2>().norm(), 0, 0.5);
}

TEST(Camera, NamedViewsLookAtTheTargetFromWhereTheySay) {
    for (const char* name : {"front", "three_quarter", "side", "back", "top", "low", "close"}) {
        const CameraView* view = find_camera_view(name);
        ASSERT_NE(view, nullptr) << name;
        CameraParams p = straight();
        look_from(p, *view);
        EXPECT_NEAR(seen(p, target_of(p)).x(), kWidth / 2, 1e-2);
        EXPECT_NE(camera_view_names().find(name), std::string::npos);
    }
    CameraParams top = straight(), close = straight();
    look_from(top, *find_camera_view("top"));
    look_from(close, *find_camera_view("close"));
    EXPECT_GT(make_camera(top, 1, 1).eye.y(), 0.9f);
    EXPECT_LT(close.distance, 0.5 * straight().distance);
    EXPECT_EQ(find_camera_view("nowhere"), nullptr);
}

TEST(Camera, SeesASphereThatReachesIntoThePicture) {
    const CameraParams p = straight();
    const Camera camera = make_camera(p, kWidth, kHeight);
    const Vector3f target = target_of(p);
    EXPECT_TRUE(sees(camera, target, 0.01f));
    EXPECT_FALSE(sees(camera, target + Vector3f(1, 0, 0), 0.1f));
    EXPECT_TRUE(sees(camera, target + Vector3f(1, 0, 0), 0.9f));
    EXPECT_FALSE(sees(camera, target + Vector3f(0, 0, 2), 0.1f)) << "behind";
    EXPECT_FALSE(sees(camera, target + Vector3f(0, -0.5f, 0), 0.1f));
}

}  // namespace
}  // namespace ember
