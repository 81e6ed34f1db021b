// How ash is loaded and how strong it is: which way it would break first.
//
// All tensors are in sheet coordinates: x along the main direction, z across it.
#pragma once

#include <array>

#include "sim/lattice.h"
#include "sim/params.h"
#include "sim/world_state.h"

namespace ember {

/// A symmetric 2×2 tensor.
struct PlaneTensor {
    double xx = 0, zz = 0, xz = 0;
    void operator+=(const PlaneTensor& t) { xx += t.xx, zz += t.zz, xz += t.xz; }
};

/// A direction in the sheet.
struct PlaneVector {
    double x = 0, z = 0;
};
[[nodiscard]] inline double dot(PlaneVector a, PlaneVector b) {
    return a.x * b.x + a.z * b.z;
}

/// The membrane stress at the node that the sectors `parts[k] == part` of a site share, averaged
/// over their quads: the virial of the springs,
///     σ = 1/(A Y) Σ k (L - l)/L_0 d d^T,   d: the spring on the unburnt sheet, L_0 = |d|,
/// of edges and diagonals of these quads and of bending springs through the site as far as it is
/// still glued. k is unburnt and Y the unburnt sheet's modulus along the main direction, so σ is
/// in units of strain [1]: 0.01 where the whole sheet is pulled by 1 % along x.
[[nodiscard]] PlaneTensor part_stress(const Lattice& lattice, const SheetState& sheet, Index site,
                                      const std::array<int, 4>& parts, int part);

/// The mean of part_stress() over the burnt parts of all sites up to two sites away, weighted by
/// area and by closeness.
[[nodiscard]] PlaneTensor mean_stress(const Lattice& lattice, const SheetState& sheet, Index site);

/// Young's modulus of the unburnt lattice along the main direction [N/m].
[[nodiscard]] double main_modulus(const Lattice& lattice);

/// By how much ash is stronger or weaker than fracture.threshold at a site [1]: it weakens with
/// time since burnout, share + (1 - share) exp(-age/life), life = ash_time × grammage / 80 g/m²;
/// and it varies smoothly from place to place
/// by fracture.strength_noise.
[[nodiscard]] double relative_strength(const Lattice& lattice, const SheetState& sheet,
                                       const Params& params, std::size_t sheet_number, Index site,
                                       double time);

/// Strength across each direction n, n^T S n, relative to that along the main direction: weaker
/// across the fibres by `grain`, and weaker by `boundary` across the line that the fire front left
/// here, whose normal is the gradient of the burnout time.
[[nodiscard]] PlaneTensor strength_tensor(const Lattice& lattice, const SheetState& sheet,
                                          const FractureParams& fracture, Index site);

/// The unit normal n of the crack that opens first, which maximises σ(n)/S(n) =
/// (n^T σ n)/(n^T S n), and that ratio: the top of the generalised eigenvalue problem σ n = λ S n.
struct WeakestDirection {
    PlaneVector normal;
    double ratio;
};
[[nodiscard]] WeakestDirection weakest_direction(const PlaneTensor& stress,
                                                 const PlaneTensor& strength);

}  // namespace ember
