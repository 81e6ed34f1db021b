// Faults of the renderer, one at a time: each must change a picture by a bit, and nearly all by so
// much that another version of the rasteriser could not be the reason. What is expected is drawn by
// the same program without a fault. Prints a line for every fault, for run_mutants.py.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "burnt_scenes.h"
#include "render/image_difference.h"
#include "support/gl_rig.h"

extern int ember_mutant;

namespace ember {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 240, kHeight = 135;

struct Mutant {
    int number = 0;
    std::string fault;
};

// The list that plant.py has written.
std::vector<Mutant> mutants() {
    std::vector<Mutant> list;
    std::ifstream file(EMBERLEAF_PLANTED "/mutants.txt");
    for (Mutant m; file >> m.number && std::getline(file >> std::ws, m.fault);)
        list.push_back(m);
    return list;
}

// How far pictures with a fault are from those without: the most of those that were drawn.
struct Distance {
    std::int64_t pixels = 0, far = 0;  // that differ; by more than two levels
    double block = 0;                  // [levels] of the worst block
    std::string exact, close;          // the first scene that each tier notices it in
};

// What the second tier allows (docs/GOLDEN.md).
const DifferenceLimits& close_limits(ViewMode mode) {
    return mode == ViewMode::Lattice || mode == ViewMode::Stiffness ? kCloseLineLimits
                                                                    : kCloseLimits;
}

class Gallery {
  public:
    Gallery() {
        const char* keep = std::getenv("EMBERLEAF_KEEP_SCENES");  // a folder, to look at them
        for (const test::BurntScene& scene : scenes_) {
            expected_.push_back(draw(scene));
            if (keep != nullptr)
                write_png(fs::path(keep) / (scene.name + ".png"), expected_.back());
        }
    }

    // Draws scene after scene with mutant `number`, until both tiers have noticed it.
    Distance look(int number) {
        const fs::path shaders = EMBERLEAF_PLANTED "/shaders/" + std::to_string(number);
        ember_mutant = number;
        rig_.renderer.reload(fs::exists(shaders) ? shaders : fs::path());
        Distance sum;
        for (std::size_t i = 0; i < scenes_.size() && (sum.exact.empty() || sum.close.empty());
             ++i) {
            const ImageDifference d = compare(expected_[i], draw(scenes_[i]));
            const bool far = !excess(d, close_limits(scenes_[i].params.view.mode)).empty();
            if (sum.exact.empty() && !d.identical()) sum.exact = scenes_[i].name;
            if (sum.close.empty() && far) sum.close = scenes_[i].name;
            sum.pixels = std::max(sum.pixels, d.pixels);
            sum.far = std::max(sum.far, d.pixels_over(2));
            sum.block = std::max(sum.block, d.worst_block);
        }
        ember_mutant = 0;
        return sum;
    }

  private:
    Image draw(const test::BurntScene& scene) {
        const WorldView world = scene.world->view();
        return rig_.renderer.draw_image({&world, scene.springs}, scene.params, kWidth, kHeight);
    }

    std::vector<test::BurntScene> scenes_ = test::burnt_scenes();
    test::GlRig rig_;
    std::vector<Image> expected_;
};

TEST(RenderMutants, AreAllCaughtByExactPixelsAndNearlyAllByTheSecondTier) {
    const std::vector<Mutant> list = mutants();
    ASSERT_GE(list.size(), 20u);
    const char* wish = std::getenv("EMBERLEAF_MUTANT");
    Gallery gallery;
    const Distance none = gallery.look(0);
    ASSERT_EQ(none.pixels, 0) << "without a fault the pictures must not change";
    std::size_t tried = 0, close = 0;
    for (const Mutant& m : list) {
        if (wish != nullptr && std::to_string(m.number) != wish) continue;
        const Distance d = gallery.look(m.number);
        std::printf("mutant %d exact=%s close=%s pixels=%lld far=%lld block=%.3f\n", m.number,
                    d.exact.empty() ? "-" : d.exact.c_str(),
                    d.close.empty() ? "-" : d.close.c_str(), static_cast<long long>(d.pixels),
                    static_cast<long long>(d.far), d.block);
        std::fflush(stdout);
        EXPECT_FALSE(d.exact.empty())
            << "mutant " << m.number << " changes no picture: " << m.fault;
        ++tried;
        if (!d.close.empty()) ++close;
    }
    EXPECT_GT(tried, 0u) << "EMBERLEAF_MUTANT names none";
    EXPECT_GE(10 * close, 9 * tried) << "the second tier misses more than one in ten";
}

}  // namespace
}  // namespace ember
