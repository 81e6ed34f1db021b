// Three frames of presets/paper/corner, compared to the bit with those in golden/.
//
// After a change that is meant to change them, look at the new pictures and run
//     EMBERLEAF_UPDATE_GOLDEN=1 ./test -L golden
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "render/image_difference.h"
#include "support/burnt_corner.h"
#include "support/gl_rig.h"

namespace ember {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 480, kHeight = 270;
constexpr std::uint64_t kTicks[] = {60, 240, 360};  // 1, 4 and 6 s

fs::path golden_folder() {
    return EMBERLEAF_SOURCE "/tests/render/golden";
}

std::string name_of(std::uint64_t tick) {
    return "corner_" + std::to_string(tick);
}

std::string hex(std::uint64_t hash) {
    std::ostringstream text;
    text << std::hex << std::setw(16) << std::setfill('0') << hash;
    return text.str();
}

// The state that a golden picture shows; empty when there is no record.
std::string recorded_hash(std::uint64_t tick) {
    std::ifstream file(golden_folder() / (name_of(tick) + ".hash"));
    std::string hash;
    file >> hash;
    return hash;
}

void update(std::uint64_t tick, const std::string& hash, const Image& image) {
    fs::create_directories(golden_folder());
    write_png(golden_folder() / (name_of(tick) + ".png"), image);
    std::ofstream(golden_folder() / (name_of(tick) + ".hash")) << hash << '\n';
}

// Compares; on a difference leaves what was drawn and the difference beside the test's output.
void expect_golden(std::uint64_t tick, const Image& drawn) {
    const Image golden = read_image(golden_folder() / (name_of(tick) + ".png"));
    const ImageDifference d = compare(golden, drawn);
    if (d.identical()) return;
    const fs::path out = fs::current_path() / "golden_failures";
    fs::create_directories(out);
    write_png(out / (name_of(tick) + "_drawn.png"), drawn);
    if (d.comparable) {
        write_png(out / (name_of(tick) + "_difference.png"), difference_image(golden, drawn));
    }
    ADD_FAILURE() << name_of(tick) << ": " << d.pixels << " pixels differ, by up to "
                  << d.max_difference << " levels; see " << out.string();
}

TEST(Golden, ThreeFramesOfTheBurningCornerAreWhatTheyWere) {
    const char* wish = std::getenv("EMBERLEAF_UPDATE_GOLDEN");
    const bool updating = wish != nullptr && std::string(wish) == "1";
    test::BurntCorner corner;
    test::GlRig rig;
    for (const std::uint64_t tick : kTicks) {
        corner.burn_until(tick);
        const std::string hash = hex(corner.world().hash());
        const Image drawn = rig.draw(corner.world().view(), corner.render(), kWidth, kHeight);
        if (updating) {
            update(tick, hash, drawn);
            continue;
        }
        // a burn that differs is no fault of the renderer's and would only confuse
        ASSERT_EQ(hash, recorded_hash(tick)) << "the simulation of tick " << tick
                                             << " has changed, so its picture cannot be compared";
        expect_golden(tick, drawn);
    }
}

}  // namespace
}  // namespace ember
