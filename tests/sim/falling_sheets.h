// Loose sheets above the ground, for the tests of contact.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "rig.h"
#include "sim/world.h"

namespace ember::test {

inline constexpr double kGravity = 9.81;

/// Sheets of 6 by 8 cm that fall onto the ground.
inline Params falling() {
    Params p = plain(6, 8);
    p.world.gravity = kGravity;
    p.world.ground = true;
    p.springs.stiffness_scale = 40;
    return p;
}

/// A horizontal sheet of `params` with its first corner at `origin`.
inline SheetPlan plan_at(const Params& params, const Vector3& origin) {
    SheetPlan plan = make_scene(params).sheets[0];
    plan.origin = origin;
    return plan;
}

/// One such sheet at each place [m].
inline World world_of(const Params& params, const std::vector<Vector3>& origins, int threads = 1) {
    Scene scene;
    for (const Vector3& origin : origins)
        scene.sheets.push_back(plan_at(params, origin));
    return World(scene, params, threads);
}

/// Takes ticks that must succeed; the sum of what contact did.
inline StepCounters run(World& world, double seconds) {
    StepCounters sum;
    for (double t = 0; t < seconds; t += world.tick_duration()) {
        const StepReport report = world.step();
        EXPECT_TRUE(report.ok()) << cause_text(report);
        sum.contacts += report.counters.contacts;
        sum.contact_visited += report.counters.contact_visited;
        sum.contact_pairs += report.counters.contact_pairs;
    }
    return sum;
}

/// One above the other, a little aside.
inline std::vector<Vector3> four_places() {
    return {Vector3(0, 0.020, 0), Vector3(0.004, 0.040, -0.003), Vector3(-0.003, 0.060, 0.006),
            Vector3(0.007, 0.080, 0.002)};
}

}  // namespace ember::test
