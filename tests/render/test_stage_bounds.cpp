// Where the paper is, and what of it hides the sky.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "render/lighting.h"
#include "render/stage_bounds.h"
#include "support/staged_world.h"

namespace ember {
namespace {

TEST(StageBounds, ContainEveryNodeAndNothingOfAnEmptyWorld) {
    test::StagedWorld staged = test::hanging_sheet(5, 7);
    const Bounds bounds = bounds_of(staged.view());
    EXPECT_NEAR(bounds.radius, 0.5 * std::hypot(0.210, 0.297), 1e-6);
    EXPECT_NEAR(bounds.centre.y(), 0.45 - 0.5 * 0.297, 1e-6);
    EXPECT_EQ(bounds_of(WorldView{}).radius, 0.0f);
}

TEST(StageBounds, OccludersHaveTheAreaOfTheSheet) {
    for (const int rows : {3, 33}) {
        const test::StagedWorld staged = test::hanging_sheet(rows, 49);
        const auto occluders = gather_occluders(staged.view());
        ASSERT_GT(occluders.size(), 1u);
        ASSERT_LE(occluders.size(), static_cast<std::size_t>(kMostOccluders));
        float area = 0;
        for (const Occluder& o : occluders) {
            area += o.place.w();
            EXPECT_NEAR(std::abs(o.normal.z()), 1.0f, 1e-5f);
        }
        EXPECT_NEAR(area, 0.210 * 0.297, 1e-5);
    }
}

TEST(StageBounds, ManySheetsShareTheOccluders) {
    const test::StagedWorld staged = test::hanging_sheet(9, 9);
    WorldView world = staged.view();
    while (world.sheets.size() < 40)
        world.sheets.push_back(world.sheets.front());
    EXPECT_LE(gather_occluders(world).size(), static_cast<std::size_t>(kMostOccluders));
}

TEST(Lighting, TheLampTurnsAroundThePaperToTheRight) {
    const Eigen::Vector3f lamp = lighting_of(LightingPreset::Studio).key_direction;
    EXPECT_EQ(lighting_of(LightingPreset::Studio, 0).key_direction, lamp);
    const Eigen::Vector3f turned = lighting_of(LightingPreset::Studio, 0.5 * M_PI).key_direction;
    EXPECT_NEAR((turned - Eigen::Vector3f(lamp.z(), lamp.y(), -lamp.x())).norm(), 0, 1e-6f)
        << "what is in front comes to the right";
}

// The shadow map sees all paper, nearer to the lamp at smaller depth.
TEST(StageBounds, TheLampSeesAllPaperWithDepthAwayFromTheLamp) {
    const test::StagedWorld staged = test::hanging_sheet(5, 7);
    const WorldView world = staged.view();
    for (const LightingPreset preset : {LightingPreset::Studio, LightingPreset::Night}) {
        const Eigen::Vector3f lamp = lighting_of(preset).key_direction;
        EXPECT_NEAR(lamp.norm(), 1.0f, 1e-6f);
        const Eigen::Matrix4f matrix = shadow_from_world(bounds_of(world), lamp);
        for (std::size_t n = 0; n < staged.x.size(); ++n) {
            const Eigen::Vector3f at(Eigen::Vector3d(staged.x[n], staged.y[n], 0).cast<float>());
            const Eigen::Vector3f seen = (matrix * at.homogeneous()).head<3>();
            EXPECT_GT(seen.minCoeff(), 0.0f);
            EXPECT_LT(seen.maxCoeff(), 1.0f);
            const Eigen::Vector3f nearer = (matrix * (at + 0.01f * lamp).homogeneous()).head<3>();
            EXPECT_LT(nearer.z(), seen.z());
            EXPECT_NEAR((nearer - seen).head<2>().norm(), 0, 1e-5f);
        }
    }
}

}  // namespace
}  // namespace ember
