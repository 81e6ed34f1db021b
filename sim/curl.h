// Curl: what the difference between a sheet's two faces does to its curvature at rest (plate.h),
// and how charring keeps the curvature that it meets. Beyond the paper.
//
// The two halves of the caliper h are taken as the layers of a strip that shrink by strains that
// differ by ε; without moments such a strip has the curvature 3 ε / 2h (Timoshenko 1925, equal
// layers), towards the half that shrinks more. Here
// ε = heat · θ + charring · χ + two_sided · p:
//
//   θ [K]  by how much the half towards the normal is hotter. Fire gives all its heat to the half
//          that it is on, and heat crosses the caliper:
//              θ' = 2 S (n·d) - θ/τ,   τ = ρ c h² / 8 D
//          with S what the node receives from particles, and d their mean distance from it over
//          the radius of the kernel: 0 from all around, towards 1 from one side.
//   χ [1]  by how much that half is charred more: while a node loses the share df of what it loses
//          in burning, χ grows by df · θ/√(θ² + θ_c²), θ_c = 100 K.
//   p [1]  the share that it has lost of that. Paper has a wire side and a felt side, which differ
//      in fillers and in how their fibres lie, so it curls even when heated evenly.
//
// A lattice resolves no radius much below two cells, so the curvature κ of either direction counts
// as κ/√(1 + (2 h_max κ)²), h_max the longer side of a cell: by 1 % less at 3.5 cells, never more
// than 1 / 2 h_max.
//
// While a node chars, its curvature at rest creeps to the present one (by the same law): by
// 1 - e^(-set · df).
#pragma once

#include <vector>

#include "sim/fire_coupling.h"
#include "sim/plate.h"
#include "sim/step_stats.h"

namespace ember {

/// Scratch of advance_curl(); S each.
struct CurlScratch {
    Vector3Array normal;                          ///< [1] N
    std::vector<double> charred;                  ///< [1] df of each site
    std::vector<double> main, cross, twist;       ///< [1/m] present curvature of sites and cells ..
    std::vector<double> main_share, cross_share;  ///< [N/m] .. and the weight of what it is from
};

/// Curvature [1/m] of a sheet of caliper h [m] without moments whose halves shrink by strains that
/// differ by `strain`.
[[nodiscard]] constexpr double bilayer_curvature(double strain, double caliper) {
    return 1.5 * strain / caliper;
}

/// What the lattice resolves of a curvature [1/m]; see above.
[[nodiscard]] double resolved_curvature(const Lattice& lattice, double curvature);

/// τ [s], +inf without conduction.
[[nodiscard]] double face_relaxation_time(const PaperParams& paper);

/// Advances SheetState::faces by dt [s] and the curvatures at rest with them. `fire` is what the
/// sheet has received in the tick. Held nodes keep theirs. Returns whether anything has changed; a
/// sheet whose faces do not differ and of which nothing chars is only looked at.
bool advance_curl(const Lattice& lattice, const Plate& plate, const Params& params,
                  const NodeFire& fire, double dt, SheetState& sheet, CurlScratch& scratch,
                  StepCounters& counters);

}  // namespace ember
