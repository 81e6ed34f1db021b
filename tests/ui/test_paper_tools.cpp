// What the mouse does to the paper.
#include "bench_rig.h"
#include "sim/lighter.h"
#include "ui/paper_tools.h"
#include "ui/pick.h"

namespace ember {
namespace {

constexpr double kWidth = 640, kHeight = 360;

class Tools : public AtTheBench {
  protected:
    [[nodiscard]] PictureCamera picture() const {
        return {make_camera(bench_->values.render.camera, 640, 360), {0, 0, kWidth, kHeight}};
    }
    // Where a node is on the picture.
    [[nodiscard]] PicturePoint on_screen(std::size_t node) const {
        const SheetView& sheet = bench_->snapshot().view.sheets[0];
        const Eigen::Vector3f p =
            project(picture().camera,
                    Vector3(sheet.x[node], sheet.y[node], sheet.z[node]).cast<float>(), 640, 360);
        return {double(p.x()), double(p.y())};
    }
    void use(Drag drag, PicturePoint from, PicturePoint to) {
        busy_ = true;
        tools_.use({drag, from, from, true, false}, picture(), *bench_);
        steps(3);
        tools_.use({drag, to, from, false, false}, picture(), *bench_);
        steps(3);
    }
    void let_go(Drag drag, PicturePoint from, PicturePoint to) {
        tools_.use({drag, to, from, false, true}, picture(), *bench_);
        busy_ = false;
        frames();
    }
    PaperTools tools_;
    std::size_t middle_ = 6 * 17 + 8;
};

TEST_F(Tools, TheRayThroughANodeMeetsIt) {
    const auto hit =
        pick_sheet(bench_->snapshot().view, picture().eye(), picture().ray(on_screen(middle_)));
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->node, middle_);
    const PicturePoint at = on_screen(middle_);
    EXPECT_NEAR((picture().beside(hit->place, at) - hit->place).norm(), 0, 1e-6);
}

TEST_F(Tools, ATouchPullsThePaperAndLeavesNoTraceInThePreset) {
    const PicturePoint from = on_screen(middle_), to{from.x + 40, from.y};
    const auto place = [&] {
        const SheetView& sheet = bench_->snapshot().view.sheets[0];
        return Vector3(sheet.x[middle_], sheet.y[middle_], sheet.z[middle_]);
    };
    const Vector3 before = place();
    use(Drag::Touch, from, to);
    EXPECT_TRUE(bench_->snapshot().params.hand.on);
    EXPECT_EQ(bench_->snapshot().params.hand.row, 6);
    EXPECT_EQ(bench_->snapshot().params.hand.column, 8);
    steps(20);
    const HandParams& hand = bench_->snapshot().params.hand;
    const Vector3 wanted = Vector3(hand.x, hand.y, hand.z) - before;
    EXPECT_GT((place() - before).dot(wanted.normalized()), 0.003);
    let_go(Drag::Touch, from, to);
    EXPECT_FALSE(bench_->snapshot().params.hand.on);
    EXPECT_FALSE(bench_->dirty());
    EXPECT_EQ(bench_->history().size(), 0u);
    EXPECT_GE(bench_->snapshot().script->size(), 2u) << "but the take knows";
}

TEST_F(Tools, ATouchBesideThePaperTouchesNothing) {
    use(Drag::Touch, {2, 2}, {30, 30});
    EXPECT_FALSE(bench_->snapshot().params.hand.on);
}

TEST_F(Tools, BlowingIsWindWhileItLasts) {
    use(Drag::Blow, {100, 200}, {280, 200});
    const WindParams& wind = bench_->snapshot().params.wind;
    const double speed = std::hypot(wind.x, wind.z);
    EXPECT_NEAR(speed, 8.0 * 180 / kHeight, 1e-4) << "half the picture's height";
    let_go(Drag::Blow, {100, 200}, {280, 200});
    EXPECT_EQ(bench_->snapshot().params.wind.x, 0);
    EXPECT_FALSE(bench_->dirty());
}

TEST_F(Tools, PaintingSetsFireWhereTheMouseIsAndStops) {
    const PicturePoint from = on_screen(middle_), to = on_screen(middle_ + 3);
    use(Drag::Ignite, from, to);
    ASSERT_EQ(bench_->snapshot().view.lighters.size(), 2u);
    EXPECT_TRUE(bench_->snapshot().view.lighters[1].lit);
    EXPECT_EQ(bench_->lighter, 0u) << "the panel stays with its lighter";
    steps(60);
    EXPECT_GT(bench_->snapshot().stats.burning, 0);
    let_go(Drag::Ignite, from, to);
    EXPECT_FALSE(bench_->snapshot().view.lighters[1].lit);
}

}  // namespace
}  // namespace ember
