// The bytes of saved simulations, within this process: what is read, what is refused, and that a
// world goes on from them as if nothing had happened.
#include "app/checkpoint_format.h"

#include <gtest/gtest.h>

#include <fstream>

#include "app/checkpoint.h"
#include "app/exit_code.h"
#include "sim/random.h"

namespace ember {
namespace {

// Few cells, so that thousands of states are soon made.
LoadedPreset small_preset(const std::string& name, const std::vector<std::string>& sets = {}) {
    RunOptions options;
    options.preset = name;
    options.sets = {"sheet.rows=6", "sheet.columns=9"};
    // small paper is alight sooner; a leaf is held at places of its own
    if (name.starts_with("paper/"))
        options.sets.insert(options.sets.end(), {"sheet.width=40", "sheet.height=60"});
    options.sets.insert(options.sets.end(), sets.begin(), sets.end());
    return load_run(options);
}

void advance(World& world, int ticks) {
    for (int i = 0; i < ticks; ++i)
        ASSERT_TRUE(world.step().ok());
}

std::string refusal(std::string_view bytes, World& world, const LoadedPreset& preset) {
    try {
        resume_from(bytes, world, preset);
    } catch (const std::runtime_error& e) {
        return e.what();
    }
    return "";
}

std::string kept_file(const std::string& name) {
    std::ifstream in(std::string(EMBERLEAF_SOURCE) + "/tests/app/states/" + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

// Saved after k of N ticks and gone on with in another world, with another number of threads.
void expect_same_from_every_tick(const LoadedPreset& preset, int from, int to) {
    World whole = build_world(preset, 1);
    advance(whole, from);
    EXPECT_GT(whole.state().fire.size(), 0u) << "a check without fire";
    std::vector<std::string> saved;
    for (int k = from; k < to; ++k) {
        saved.push_back(checkpoint_bytes(whole, preset));
        advance(whole, 1);
    }
    for (std::size_t i = 0; i < saved.size(); ++i) {
        World resumed = build_world(preset, i % 2 == 0 ? 3 : 1);
        ASSERT_EQ(refusal(saved[i], resumed, preset), "");
        advance(resumed, to - from - static_cast<int>(i));
        EXPECT_EQ(resumed.hash(), whole.hash()) << "saved after " << from + static_cast<int>(i);
    }
}

TEST(CheckpointFormat, EveryTickGoesOnToTheSameBitsWithAnotherNumberOfThreads) {
    for (const char* name : {"paper/corner", "paper/stack", "real/office", "scenes/leaf"}) {
        SCOPED_TRACE(name);
        expect_same_from_every_tick(small_preset(name, {"burning.burn_speed=4"}), 40, 60);
    }
}

TEST(CheckpointFormat, EveryIntegratorAndHeatSolverGoesOnToTheSameBits) {
    for (const char* scheme : {"semi_implicit_euler", "velocity_verlet", "rk4", "dopri5", "rkf78",
                               "adams_bashforth_moulton", "rosenbrock"}) {
        SCOPED_TRACE(scheme);
        expect_same_from_every_tick(
            small_preset("paper/corner", {std::string("numerics.integrator=") + scheme}), 30, 36);
    }
    for (const char* solver : {"ftcs", "rkl2", "adi"}) {
        SCOPED_TRACE(solver);
        expect_same_from_every_tick(
            small_preset("paper/corner", {std::string("numerics.heat_solver=") + solver}), 30, 36);
    }
}

TEST(CheckpointFormat, TenThousandFlippedBitsAreRefusedAndTheWorldIsAsBefore) {
    const LoadedPreset preset = small_preset("paper/corner");
    World world = build_world(preset, 1);
    advance(world, 30);
    const std::string bytes = checkpoint_bytes(world, preset);
    advance(world, 5);
    const std::uint64_t running = world.hash();
    const std::size_t bits = 8 * bytes.size();
    std::string flipped = bytes;
    for (std::uint64_t i = 0; i < 10'000; ++i) {
        // every one of the beginning, where lengths and versions are, then anywhere
        const std::size_t bit = i < 4096 ? i : random_bits(1, RandomUse::Waviness, i, 0) % bits;
        const auto mask = static_cast<char>(1 << bit % 8);
        flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ mask);
        ASSERT_NE(refusal(flipped, world, preset), "") << "bit " << bit;
        ASSERT_EQ(world.hash(), running) << "bit " << bit;
        flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ mask);
    }
    EXPECT_EQ(refusal(flipped, world, preset), "");
    EXPECT_NE(world.hash(), running);
}

TEST(CheckpointFormat, WhatIsCutOffOrGoesOnIsRefused) {
    const LoadedPreset preset = small_preset("paper/corner");
    World world = build_world(preset, 1);
    advance(world, 10);
    const std::uint64_t running = world.hash();
    const std::string bytes = checkpoint_bytes(world, preset);
    for (std::size_t size = 0; size < bytes.size(); size += size < 400 ? 1 : 37)
        ASSERT_NE(refusal(std::string_view(bytes).substr(0, size), world, preset), "") << size;
    EXPECT_EQ(refusal(bytes + '\0', world, preset), "damaged: there is more after its end");
    EXPECT_EQ(world.hash(), running);
}

TEST(CheckpointFormat, ARefusalSaysWhichVersionsAndParameters) {
    const LoadedPreset preset = small_preset("paper/corner");
    World world = build_world(preset, 1);
    const SavedState saved = read_saved_bytes(checkpoint_bytes(world, preset));
    const auto refused = [&](const std::string& program, std::uint64_t parameters) {
        return refusal(saved_bytes(program, parameters, saved.state), world, preset);
    };
    EXPECT_EQ(refused(saved.program, saved.parameters), "");
    EXPECT_EQ(refused("0.0.1 (old)", saved.parameters).find("saved by emberleaf 0.0.1 (old); this"),
              0u);
    EXPECT_EQ(refused(saved.program, saved.parameters ^ 1), "saved with other parameters");
    EXPECT_EQ(refusal("emberleaf state 3\n", world, preset),
              "saved in format 3; this program reads format 2");
    EXPECT_EQ(refusal("emberleaf state two\n", world, preset), "not a saved simulation");
}

// Whole and undamaged, and yet of no use: made by a hand that knows the checksums.
TEST(CheckpointFormat, AStateThatDoesNotFitTheSceneIsRefused) {
    const LoadedPreset preset = small_preset("paper/corner");
    World world = build_world(preset, 1);
    const std::uint64_t running = world.hash();
    const SavedState good = read_saved_bytes(checkpoint_bytes(world, preset));
    const auto refused = [&](auto&& change) {
        WorldState state = good.state;
        change(state);
        const std::string reason =
            refusal(saved_bytes(good.program, good.parameters, state), world, preset);
        EXPECT_EQ(reason.find("saved from another scene: "), 0u) << reason;
    };
    refused([](WorldState& s) { s.sheets.clear(); });
    refused([](WorldState& s) { s.sheets.push_back(s.sheets[0]); });
    refused([](WorldState& s) { s.sheets[0].mass.pop_back(); });
    refused([](WorldState& s) { s.sheets[0].velocity.y.push_back(0); });
    refused([](WorldState& s) { s.sheets[0].glue.pop_back(); });
    refused([](WorldState& s) { s.sheets[0].quiet_ticks.clear(); });
    refused([](WorldState& s) { s.sheets[0].rest_length.push_back(1); });
    refused([](WorldState& s) { s.sheets[0].quads.pop_back(); });
    refused([](WorldState& s) { s.sheets[0].quads[5][2] = 70; });
    refused([](WorldState& s) { s.sheets[0].quads[5][2] = -2; });
    refused([](WorldState& s) { s.sheets[0].site[3] = 1000; });
    refused([](WorldState& s) { s.sheets[0].cracks.due.resize(2); });
    refused([](WorldState& s) { s.sheets[0].rest_curvature.main.resize(70); });
    refused([](WorldState& s) { s.fire.id.push_back(1); });
    EXPECT_EQ(world.hash(), running);
}

TEST(CheckpointFormat, TheKeptFileOfThisFormatIsReadToTheBit) {
    const SavedState saved = read_saved_bytes(kept_file("format2.state"));
    EXPECT_EQ(saved.program.find("0.1.0 ("), 0u);
    EXPECT_EQ(saved.state.tick, 30u);
    EXPECT_EQ(saved.state.sheets.size(), 1u);
    EXPECT_EQ(hash_of(saved.state), 0x17bc7f14f4ee9f49ull);
    const std::string bytes = kept_file("format2.state");
    EXPECT_EQ(saved_bytes(saved.program, saved.parameters, saved.state), bytes);
}

TEST(CheckpointFormat, KeptFilesOfEarlierFormatsAreRefusedByName) {
    const LoadedPreset preset = small_preset("paper/corner");
    World world = build_world(preset, 1);
    EXPECT_EQ(refusal(kept_file("format1.state"), world, preset),
              "saved in format 1; this program reads format 2");
}

}  // namespace
}  // namespace ember
