#include "swing_problem.h"

#include <algorithm>
#include <cmath>

namespace ember::peers {
namespace {

class Ember final : public RightHandSide {
  public:
    explicit Ember(test::Rig& rig) : mechanics_(rig.mechanics()) {}

  private:
    void evaluate(const double* y, double* dydt) override {
        const std::size_t n = mechanics_.node_count();
        std::copy_n(y + 3 * n, 3 * n, dydt);
        (void)accelerate(mechanics_, y, y + 3 * n, dydt + 3 * n);
    }

    Mechanics mechanics_;
};
static_assert(RightHandSide::kPadding >= kMotionPadding);

// A diagonal that rises goes from (r, c+1) to (r+1, c); the others begin at their anchor.
constexpr int kRowsAhead[] = {0, 1, 1, 1, 0, 2}, kColumnsAhead[] = {1, 0, 1, -1, 2, 0};

}  // namespace

test::Rig make_swing(int rows, int columns, Arithmetic arithmetic) {
    Params p = test::swing(rows, columns);
    p.numerics.arithmetic = arithmetic;
    return test::Rig(p);
}

std::unique_ptr<RightHandSide> ember_right_hand_side(test::Rig& rig) {
    return std::make_unique<Ember>(rig);
}

PlainProblem translate(const test::Rig& rig) {
    PlainProblem p;
    p.rows = rig.lattice.row_count;
    p.columns = rig.lattice.column_count;
    p.inverse_mass = rig.loads.inverse_mass;
    p.load_y = rig.loads.force.y;
    const std::size_t n = p.load_y.size();
    for (int k = 0; k < kSlotCount; ++k) {
        SpringField field;
        field.rows_ahead = kRowsAhead[k];
        field.columns_ahead = kColumnsAhead[k];
        for (auto* array : {&field.stiffness, &field.damping, &field.rest})
            array->assign(n, 0.0);
        for (Index anchor = 0; anchor < rig.lattice.site_count(); ++anchor) {
            const auto [a, b] = rig.lattice.ends(static_cast<Slot>(k), anchor);
            if (a == kNone) continue;
            const auto i = static_cast<std::size_t>(a);
            const auto slot =
                static_cast<std::size_t>(rig.lattice.slot(static_cast<Slot>(k), anchor));
            field.stiffness[i] = rig.network.stiffness[slot];
            field.damping[i] = rig.network.damping[slot];
            field.rest[i] = rig.sheet.rest_length[slot];
        }
        p.springs.push_back(std::move(field));
    }
    return p;
}

std::vector<double> state_of(const test::Rig& rig) {
    Motion motion;
    motion.read(rig.sheet);
    const auto n3 = static_cast<std::ptrdiff_t>(3 * rig.sheet.mass.size());
    std::vector<double> y(motion.x.begin(), motion.x.begin() + n3);
    y.insert(y.end(), motion.v.begin(), motion.v.begin() + n3);
    y.resize(y.size() + RightHandSide::kPadding, 0.0);
    return y;
}

double distance(const std::vector<double>& p, const std::vector<double>& q) {
    const std::size_t count = (p.size() - RightHandSide::kPadding) / 2;
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i)
        sum += (p[i] - q[i]) * (p[i] - q[i]);
    return std::sqrt(3.0 * sum / static_cast<double>(count));
}

}  // namespace ember::peers
