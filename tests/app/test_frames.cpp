// What comes out of a run: pictures between ticks, the state as PLY, the statistics as JSON.
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/frame_source.h"
#include "app/state_ply.h"
#include "app/stats_json.h"
#include "ply_reader.h"
#include "preset_rig.h"

namespace ember {
namespace {

// A small sheet that is alight within half a second and cracks soon after.
LoadedPreset small_burn() {
    LoadedPreset preset;
    Params& p = preset.params;
    p.sheet.rows = 12;
    p.sheet.columns = 18;
    p.sheet.width = 0.0788;
    p.sheet.height = 0.1114;
    p.sheet.count = 2;
    p.springs.stiffness_scale = 10;
    p.world.held_gravity = 0.06;
    p.lighter.x = -0.04;
    p.lighter.y = p.sheet.elevation - p.sheet.height - 0.02;
    p.lighter.strength = 1;
    p.burning.burn_speed = 2;
    return preset;
}

TEST(FrameSource, PicturesNeverChangeTheSteps) {
    std::set<std::uint64_t> hashes;
    for (const double fps : {24.0, 25.0, 30000.0 / 1001.0, 30.0, 60.0}) {
        World world = make_world(small_burn().params);
        FrameSource source(world, nullptr, {}, true);
        FrameView frame;
        for (int f = 0; f / fps < 1.0; ++f)
            ASSERT_TRUE(source.show(f / fps, frame));
        ASSERT_TRUE(source.advance_to(1.0));
        EXPECT_EQ(world.state().tick, 60u);
        hashes.insert(world.hash());
    }
    EXPECT_EQ(hashes.size(), 1u);
}

TEST(FrameSource, APictureOnATickShowsTheWorldItself) {
    World world = make_world(small_burn().params);
    FrameSource source(world, nullptr, {});
    FrameView frame;
    ASSERT_TRUE(source.show(0.5, frame));
    EXPECT_EQ(frame.view.tick, 30u);
    EXPECT_EQ(frame.view.sheets[0].x.data(), world.state().sheets[0].position.x.data());
}

TEST(FrameSource, APictureBetweenTicksIsAThirdOfTheWay) {
    World world = make_world(small_burn().params), reference = make_world(small_burn().params);
    FrameSource source(world, nullptr, {}, true);
    for (int i = 0; i < 30; ++i)
        ASSERT_TRUE(reference.step().ok());
    const WorldState before = reference.snapshot();
    ASSERT_TRUE(reference.step().ok());
    const WorldState& after = reference.state();
    FrameView frame;
    for (const double share : {1.0 / 3.0, 2.0 / 3.0}) {  // the second one without a step
        ASSERT_TRUE(source.show((30 + share) / 60.0, frame));
        EXPECT_EQ(world.hash(), reference.hash());
        EXPECT_NEAR(frame.view.time, (30 + share) / 60.0, 1e-12);
        for (std::size_t s = 0; s < 2; ++s) {
            const SheetState &a = before.sheets[s], &b = after.sheets[s];
            ASSERT_EQ(frame.view.sheets[s].x.size(), a.position.size());
            for (std::size_t n = 0; n < a.position.size(); ++n) {
                const double y = a.position.y[n] + share * (b.position.y[n] - a.position.y[n]);
                EXPECT_NEAR(frame.view.sheets[s].y[n], y, 1e-12);
                EXPECT_NEAR(frame.view.sheets[s].temperature[n],
                            a.temperature[n] + share * (b.temperature[n] - a.temperature[n]), 1e-9);
            }
        }
        ASSERT_EQ(frame.view.particles.x.size(), before.fire.size());
        ASSERT_GT(before.fire.size(), 0u);
        EXPECT_NEAR(frame.view.particles.y[0],
                    before.fire.position.y[0] + share / 60.0 * before.fire.velocity.y[0], 1e-12);
    }
}

TEST(FrameSource, ShowsTheEarlierTopologyWhileACutIsMade) {
    World world = make_world(small_burn().params), reference = make_world(small_burn().params);
    FrameSource source(world, nullptr, {}, true);
    FrameView frame;
    std::size_t nodes = reference.state().sheets[0].mass.size();
    for (int tick = 1; tick < 400; ++tick) {
        ASSERT_TRUE(reference.step().ok());
        const std::size_t now = reference.state().sheets[0].mass.size();
        ASSERT_TRUE(source.show((tick - 0.5) / 60.0, frame));
        ASSERT_EQ(frame.view.sheets[0].x.size(), nodes);
        for (const SpringSegment& spring : frame.springs[0])
            ASSERT_LT(static_cast<std::size_t>(std::max(spring.a, spring.b)), nodes);
        for (const Quad& quad : frame.view.sheets[0].quads) {
            for (const Index node : quad)
                ASSERT_LT(static_cast<std::size_t>(node), nodes);
        }
        if (now > nodes) return;  // the case that matters has come
        nodes = now;
    }
    FAIL() << "no cut in this run: it tests nothing";
}

TEST(StatePly, HoldsEveryNodeAndQuadInThePromisedProperties) {
    World world = make_world(small_burn().params);
    for (int i = 0; i < 60; ++i)
        ASSERT_TRUE(world.step().ok());
    const Ply ply = read_ply(state_ply(world.view()));
    EXPECT_EQ(ply.declared, (std::vector<std::string>{
                                "double x", "double y", "double z", "double vx", "double vy",
                                "double vz", "double temperature", "double mass", "uchar phase",
                                "int sheet", "int row", "int column"}));
    const std::vector<SheetState>& sheets = world.state().sheets;
    const std::size_t first = sheets[0].mass.size();
    ASSERT_EQ(ply.vertex.at("x").size(), first + sheets[1].mass.size());
    ASSERT_EQ(ply.faces.size(), 2u * 12u * 18u);
    const std::size_t site = 5 * 19 + 7;  // row 5, column 7, in the second sheet
    EXPECT_EQ(ply.vertex.at("x")[first + site], sheets[1].position.x[site]);
    EXPECT_EQ(ply.vertex.at("vz")[first + site], sheets[1].velocity.z[site]);
    EXPECT_EQ(ply.vertex.at("mass")[first + site], sheets[1].mass[site]);
    EXPECT_DOUBLE_EQ(ply.vertex.at("temperature")[first + site],
                     sheets[1].temperature[site] - 273.15);
    EXPECT_EQ(ply.vertex.at("phase")[site], static_cast<double>(sheets[0].phase[site]));
    EXPECT_EQ(ply.vertex.at("sheet")[first + site], 1);
    EXPECT_EQ(ply.vertex.at("row")[first + site], 5);
    EXPECT_EQ(ply.vertex.at("column")[first + site], 7);
    const Quad& quad = sheets[1].quads[3];
    for (std::size_t corner = 0; corner < 4; ++corner) {
        EXPECT_EQ(ply.faces[12 * 18 + 3][corner], static_cast<int>(first) + quad[corner]);
    }
}

TEST(StatsJson, HasARecordPerTickTotalsAndTheHash) {
    const LoadedPreset preset = small_burn();
    World world = make_world(preset.params);
    StatsRecorder stats;
    for (int i = 0; i < 90; ++i)
        stats.record(world, world.step(stats.observer()));
    const auto json = nlohmann::json::parse(stats.json(world, preset));
    EXPECT_EQ(json.at("schema"), 1);
    EXPECT_EQ(json.at("seed"), preset.params.numerics.seed);
    EXPECT_FALSE(json.at("version").get<std::string>().empty());
    EXPECT_EQ(json.at("state_hash"), hash_text(world.hash()));
    ASSERT_EQ(json.at("frames").size(), 90u);
    const auto& last = json.at("frames").back();
    EXPECT_DOUBLE_EQ(last.at("t"), 1.5);
    const auto nodes = count_phases(world.state());
    EXPECT_EQ(last.at("nodes").at("unburnt"), nodes.unburnt);
    EXPECT_EQ(last.at("nodes").at("burning"), nodes.burning);
    EXPECT_EQ(last.at("nodes").at("burnt_out"), nodes.burnt_out);
    EXPECT_GT(nodes.burning + nodes.burnt_out, 0);
    EXPECT_GT(last.at("temperature").at("max"), last.at("temperature").at("min"));
    EXPECT_EQ(last.at("energy").at("kinetic"), world.state().energy.kinetic);
    EXPECT_EQ(last.at("energy").at("elastic"), world.state().energy.elastic);
    EXPECT_EQ(last.at("energy").at("gravitational"), world.state().energy.gravitational);
    EXPECT_EQ(last.at("particles"), world.state().fire.size());
    EXPECT_EQ(last.at("emitters"), nodes.burning + (world.view().lighters.front().lit ? 1 : 0));
    EXPECT_GT(last.at("substeps"), 0);
    EXPECT_EQ(last.at("ms").size(), kStageCount);
    EXPECT_GT(last.at("ms").at("springs"), 0.0);
    EXPECT_GT(last.at("work").at("spring_evaluations"), 0);
    EXPECT_LT(last.at("mass"), json.at("frames").front().at("mass"));
    EXPECT_EQ(json.at("totals").at("quads"), 2 * 12 * 18);
    EXPECT_EQ(json.at("totals").at("ignitions"), world.state().totals.ignitions);
    EXPECT_TRUE(json.at("totals").at("t90").is_null()) << "not reached yet";
}

}  // namespace
}  // namespace ember
