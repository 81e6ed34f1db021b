// One rendered frame of a burning sheet: every phase has its colour where its nodes are.
#include <gtest/gtest.h>

#include "support/burnt_corner.h"
#include "support/gl_rig.h"
#include "support/node_pixels.h"

namespace ember {
namespace {

using test::NodePixel;

constexpr int kWidth = 960, kHeight = 540;
constexpr Phase kPhases[] = {Phase::Unburnt, Phase::Burning, Phase::BurntOut};
constexpr std::uint64_t kTick = 180;  // 3 s: every phase covers a good part of the sheet

using Swap = Phase (*)(Phase);
Phase as_it_is(Phase p) {
    return p;
}
Phase unburnt_and_burning(Phase p) {
    return p == Phase::Unburnt ? Phase::Burning : p == Phase::Burning ? Phase::Unburnt : p;
}
Phase unburnt_and_burnt_out(Phase p) {
    return p == Phase::Unburnt ? Phase::BurntOut : p == Phase::BurntOut ? Phase::Unburnt : p;
}
Phase burning_and_burnt_out(Phase p) {
    return p == Phase::Burning ? Phase::BurntOut : p == Phase::BurntOut ? Phase::Burning : p;
}

class PhaseColours : public testing::Test {
  protected:
    void SetUp() override {
        corner_.burn_until(kTick);
        world_ = corner_.world().view();
        params_ = corner_.render();
        params_.view.flames = false;
        nodes_ = test::visible_nodes(world_, make_camera(params_.camera, kWidth, kHeight), kWidth,
                                     kHeight);
    }

    [[nodiscard]] double share_of(Phase phase, const std::function<bool(const NodePixel&)>& fits) {
        return share(
            nodes_, [&](std::size_t n) { return world_.sheets[0].phase[n] == phase; }, fits);
    }

    test::BurntCorner corner_;
    WorldView world_;
    RenderParams params_;
    std::vector<NodePixel> nodes_;
    test::GlRig rig_;
};

TEST_F(PhaseColours, NodesHaveThePaletteColourOfTheirPhaseInTheStateView) {
    params_.view.mode = ViewMode::State;
    const Image image = rig_.draw(world_, params_, kWidth, kHeight);
    // a pixel has the colour of the phase whose palette entry it is nearest to
    const auto worst_share = [&](Swap palette) {
        double worst = 1;
        for (const Phase phase : kPhases) {
            const double s = share_of(phase, [&](const NodePixel& n) {
                const Colour seen = test::linear_colour(image, n.x, n.y);
                const auto away = [&](Phase p) {
                    return test::distance_from_shaded(seen, phase_colour(palette(p)));
                };
                for (const Phase other : kPhases) {
                    if (other != phase && away(other) <= away(phase)) return false;
                }
                return true;
            });
            if (!(s >= worst)) worst = s;  // NaN, a phase without nodes, is worst
        }
        return worst;
    };
    EXPECT_GE(worst_share(as_it_is), 0.9);
    EXPECT_LT(worst_share(unburnt_and_burning), 0.9);
    EXPECT_LT(worst_share(unburnt_and_burnt_out), 0.9);
    EXPECT_LT(worst_share(burning_and_burnt_out), 0.9);
}

}  // namespace
}  // namespace ember
