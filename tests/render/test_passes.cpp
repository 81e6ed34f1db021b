// A pass that has nothing to draw is not run, and what has not changed is not uploaded.
#include <gtest/gtest.h>

#include "support/gl_rig.h"

namespace ember {
namespace {

using test::GlRig;
using test::in_mode;
using test::StagedWorld;

TEST(Passes, APassWithNothingToDrawIsNotRun) {
    GlRig rig;
    StagedWorld staged = test::hanging_sheet(4, 6);
    (void)rig.draw(staged.view(), in_mode(ViewMode::Beauty));
    EXPECT_EQ(rig.renderer.counters().sheets, 1);
    EXPECT_EQ(rig.renderer.counters().fire, 0) << "no particles";

    for (int i = 0; i < 40; ++i)
        staged.add_particle({0, 0.3, 0}, test::kFlame);
    (void)rig.draw(staged.view(), in_mode(ViewMode::Beauty, false));
    (void)rig.draw(staged.view(), in_mode(ViewMode::State));
    EXPECT_EQ(rig.renderer.counters().fire, 0) << "flames off, or no picture";
    (void)rig.draw(staged.view(), in_mode(ViewMode::Beauty));
    EXPECT_EQ(rig.renderer.counters().fire, 1);

    const int sheets = rig.renderer.counters().sheets;
    (void)rig.draw(staged.view(), in_mode(ViewMode::Lattice));
    EXPECT_EQ(rig.renderer.counters().lattice, 0) << "no springs";
    EXPECT_EQ(rig.renderer.counters().sheets, sheets) << "springs instead of paper";
    staged.quads.clear();
    staged.topology_version = 2;
    (void)rig.draw(staged.view(), in_mode(ViewMode::Beauty));
    EXPECT_EQ(rig.renderer.counters().sheets, sheets) << "no quads";
    EXPECT_EQ(rig.renderer.counters().frames, 6);
}

TEST(Passes, ColdPaperDoesNotBloomAndPaperOutsideThePictureIsNotDrawn) {
    GlRig rig;
    StagedWorld staged = test::hanging_sheet(4, 6);
    (void)rig.draw(staged.view(), {});
    EXPECT_EQ(rig.renderer.counters().bloom, 0);
    staged.temperature[3] = 1000;
    (void)rig.draw(staged.view(), {});
    EXPECT_EQ(rig.renderer.counters().bloom, 1);
    RenderParams away;
    away.camera.target_x = 8;
    const int sheets = rig.renderer.counters().sheets;
    for (int i = 0; i < 40; ++i)
        staged.add_particle({0, 0.3, 0}, test::kFlame);
    (void)rig.draw(staged.view(), away);
    EXPECT_EQ(rig.renderer.counters().sheets, sheets);
    EXPECT_EQ(rig.renderer.counters().fire, 0);
}

TEST(Passes, WhatHasNotChangedIsNotUploadedAgain) {
    GlRig rig;
    StagedWorld staged = test::burning_sheet(8, 12, 300);
    (void)rig.draw(staged.view(), {});
    const int first = rig.renderer.counters().uploads;
    EXPECT_EQ(first, 3) << "triangles, vertices and sprites";
    RenderParams brighter;
    brighter.look.exposure = 2;
    (void)rig.draw(staged.view(), brighter);
    EXPECT_EQ(rig.renderer.counters().uploads, first);
    staged.x[5] += 0.001;  // in the same tick
    (void)rig.draw(staged.view(), {});
    EXPECT_EQ(rig.renderer.counters().uploads, first + 1);
    for (int i = 0; i < 300; ++i)
        staged.fire_x[static_cast<std::size_t>(i)] += 0.001;
    (void)rig.draw(staged.view(), {});
    EXPECT_EQ(rig.renderer.counters().uploads, first + 2);
    staged.topology_version = 2;
    (void)rig.draw(staged.view(), {});
    EXPECT_EQ(rig.renderer.counters().uploads, first + 3);
}

TEST(Passes, EachTellsTheObserverWhenItIsDone) {
    GlRig rig;
    const StagedWorld staged = test::burning_sheet(8, 12, 300);
    std::vector<std::string> passes;
    rig.renderer.observe_passes([&](std::string_view pass) { passes.emplace_back(pass); });
    (void)rig.draw(staged.view(), {});
    EXPECT_EQ(passes, (std::vector<std::string>{"vertices", "shadow", "background", "sheets",
                                                "resolve", "fire", "bloom", "film"}));
    rig.renderer.observe_passes({});
    (void)rig.draw(staged.view(), {});
    EXPECT_EQ(passes.size(), 8u);
}

}  // namespace
}  // namespace ember
