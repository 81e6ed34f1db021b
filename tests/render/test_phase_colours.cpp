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
constexpr std::uint64_t kTick = 240;  // 4 s: every phase covers a good part of the sheet

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

// In the picture itself colours are lit, grained and glowing, so here they are told apart by what
// the eye goes by: paper is bright and pale, char and ash are dark, embers are orange.
bool like_paper(const Colour& c) {
    return test::luminance(c) > 0.2f && c.x() < 2 * c.z();
}
bool like_char(const Colour& c) {
    return test::luminance(c) < 0.2f;
}
bool like_embers(const Colour& c) {
    return test::luminance(c) > 0.02f && c.x() > 4 * c.z();
}

TEST_F(PhaseColours, InThePictureUnburntIsPaleBurntOutIsDarkAndAnEmberLineGlows) {
    const Image image = rig_.draw(world_, params_, kWidth, kHeight);
    const auto share_like = [&](Phase phase, bool (*like)(const Colour&)) {
        return share_of(
            phase, [&](const NodePixel& n) { return like(test::linear_colour(image, n.x, n.y)); });
    };
    EXPECT_GE(share_like(Phase::Unburnt, like_paper), 0.9);
    EXPECT_GE(share_like(Phase::BurntOut, like_char), 0.9);
    EXPECT_LE(share_like(Phase::Burning, like_paper), 0.1);
    EXPECT_LE(share_like(Phase::Unburnt, like_embers), 0.1);
    int glowing = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const Colour c = test::linear_colour(image, x, y);
            glowing += c.x() > 0.6f && like_embers(c) ? 1 : 0;
        }
    }
    EXPECT_GT(glowing, 100) << "an ember line";
    EXPECT_LT(glowing, 5000) << "that is thin";
    // colours of unburnt and burnt-out nodes exchanged: far from passing
    EXPECT_LE(share_like(Phase::Unburnt, like_char), 0.1);
    EXPECT_LE(share_like(Phase::BurntOut, like_paper), 0.1);
}

}  // namespace
}  // namespace ember
