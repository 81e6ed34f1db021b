// The strip test measures what it should, and the real/ presets burn as fast as paper.
#include <gtest/gtest.h>

#include "app/bench/bench_run.h"
#include "app/bench/validate_table.h"

namespace ember {
namespace {

GradeRuns grade_of(double grammage, double speed) {
    GradeRuns grade{"grade", {}, {}};
    grade.params.paper.grammage = grammage;
    StripRun run;
    run.front = {speed, 1};
    run.spread_rate = speed * grammage;
    run.residual_mass = grade.params.burning.residual_mass;
    run.shrink = 0.1;
    for (std::size_t s = 0; s < grade.runs.size(); ++s)
        grade.runs[s] = run;
    grade.runs[static_cast<std::size_t>(Spread::Up)]->front.speed = 2 * speed;
    grade.runs[static_cast<std::size_t>(Spread::Down)]->front.speed = 0.5 * speed;
    return grade;
}

int failures(const GradeRuns& grade) {
    int count = 0;
    for (const CheckLine& line : check_grade(grade))
        count += line.verdict == Verdict::Fail ? 1 : 0;
    return count;
}

TEST(Front, AKnownFrontIsMeasuredExactly) {
    std::vector<FrontPoint> points;
    for (int i = 0; i <= 30; ++i) {
        for (int row = 0; row < 10; ++row)
            points.push_back({0.005 * i, 2.0 + 0.005 * i / 0.0056});
    }
    const FrontFit fit = fit_front(points);
    EXPECT_NEAR(fit.speed, 0.0056, 1e-15);
    EXPECT_NEAR(fit.r_squared, 1, 1e-12);
}

TEST(Front, AStepOfAFrontIsNotStraight) {
    // distance 0, 0, 1, 1 at time 0, 1, 2, 3: slope 2/5, R^2 4/5
    const FrontPoint points[] = {{0, 0}, {0, 1}, {1, 2}, {1, 3}};
    EXPECT_NEAR(fit_front(points).speed, 0.4, 1e-15);
    EXPECT_NEAR(fit_front(points).r_squared, 0.8, 1e-15);
}

TEST(Front, WithoutTwoTimesThereIsNone) {
    EXPECT_EQ(fit_front({}).speed, 0);
    const FrontPoint points[] = {{0, 1}, {1, 1}};
    EXPECT_EQ(fit_front(points).speed, 0);
}

TEST(Validate, EachRequirementCanFail) {
    EXPECT_EQ(failures(grade_of(0.080, 0.0056)), 0);
    EXPECT_EQ(failures(grade_of(0.080, 0.0090)), 1) << "too fast";
    EXPECT_EQ(failures(grade_of(0.080, 0.0040)), 1) << "too slow";
    EXPECT_EQ(failures(grade_of(0.400, 0.0056)), 0) << "only reported for such a grammage";
    GradeRuns grade = grade_of(0.080, 0.0056);
    std::swap(grade.runs[1], grade.runs[2]);
    EXPECT_EQ(failures(grade), 1) << "faster down than up";
    grade = grade_of(0.080, 0.0056);
    grade.runs[0]->residual_mass += 0.02;
    EXPECT_EQ(failures(grade), 1);
    grade = grade_of(0.080, 0.0056);
    grade.runs[1]->mass_error = 1e-8;
    grade.runs[2]->heat_error = 1e-9;
    grade.runs[2]->energy_error = 2e-3;
    grade.runs[2]->failure = "stopped";
    EXPECT_EQ(failures(grade), 4);
}

}  // namespace
}  // namespace ember
