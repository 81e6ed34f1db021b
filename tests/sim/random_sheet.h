// Small sheets of any material, crumpled, partly burnt, cut and held, all at random.
#pragma once

#include "rig.h"
#include "sim/random.h"
#include "sim/topology.h"

namespace ember::test {

/// Random numbers of one trial.
class Dice {
  public:
    explicit Dice(std::uint64_t trial) : trial_(trial) {}
    double in(double low, double high) {
        return low + (high - low) * random_uniform(4711, RandomUse::Waviness, trial_, next_++);
    }
    /// Anything between 1/most and most, small and large alike.
    double factor(double most) { return std::pow(most, in(-1, 1)); }
    bool chance(double probability) { return in(0, 1) < probability; }
    int below(int count) { return static_cast<int>(in(0, count)); }
    Vector3 vector(double size) {
        const double x = in(-size, size), y = in(-size, size);
        return {x, y, in(-size, size)};
    }

  private:
    std::uint64_t trial_, next_ = 0;
};

/// 4 to 7 nodes each way, as flat sheets or tubes.
inline Params random_params(Dice& dice) {
    Params p = plain(3 + dice.below(4), 3 + dice.below(4));
    p.sheet.width *= dice.factor(2);
    p.sheet.border = dice.chance(0.3) ? Border::Uniform : Border::Tributary;
    p.sheet.shape = dice.chance(0.2) ? SheetShape::Cylinder : SheetShape::Flat;
    p.sheet.held = dice.chance(0.5) ? HeldEdge::MainStart : HeldEdge::None;
    p.paper.grammage = 0.080 * dice.factor(3);
    p.springs.structural *= dice.factor(3);
    p.springs.diagonal *= dice.factor(3);
    p.springs.bending *= dice.factor(3);
    p.springs.stiffness_scale = dice.factor(40);
    p.springs.damping = dice.chance(0.2) ? 0.0 : 5 * dice.factor(20);
    p.springs.variation = dice.in(0, 0.5);
    p.springs.variation_pattern =
        dice.chance(0.5) ? VariationPattern::PerFibre : VariationPattern::PerSpring;
    p.springs.follows_mass = dice.chance(0.7);
    p.world.air_drag = dice.chance(0.3) ? dice.in(0, 1) : 0.0;
    p.world.air_drag_tangential = dice.in(0, 1);
    return p;
}

/// Cuts some sites and burns some nodes down to a fifth of their mass; held nodes stay whole.
inline void burn_and_cut(Rig& rig, Dice& dice) {
    for (int cut = dice.chance(0.5) ? dice.below(9) : 0; cut > 0; --cut) {
        const Index site = dice.below(rig.lattice.site_count());
        cut_site(rig.lattice, rig.sheet, site,
                 dice.chance(0.5) ? CutLine::AlongMain : CutLine::AlongCross);
    }
    if (!dice.chance(0.7)) return;
    const double burnt = dice.in(0, 1);
    for (double& mass : rig.sheet.mass)
        mass *= dice.chance(burnt) ? dice.in(0.2, 1.0) : 1.0;
}

/// Stretches or compresses the whole sheet, and moves every node by up to 0.4 of a cell.
inline void crumple(Rig& rig, Dice& dice) {
    const Vector3 stretch(dice.in(0.7, 1.4), 1.0, dice.in(0.7, 1.4));
    const double size = dice.in(0, 0.4) * std::min(rig.lattice.column_spacing,  //
                                                   rig.lattice.row_spacing);
    for (std::size_t n = 0; n < rig.sheet.mass.size(); ++n) {
        const Vector3 place = rig.sheet.position.at(n).cwiseProduct(stretch);
        rig.sheet.position.set(n, place + dice.vector(size));
    }
}

}  // namespace ember::test
