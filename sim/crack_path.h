// Cracks of any direction as paths along the edges of the lattice, like a line drawn with pixels.
//
//      +───+───+───+       A crack is an ideal curve; the path (═, ‖) takes at each site the edge
//      │   │   ╔═══+       that stays closest to it. What lies between the site and the curve is
//      +───+───╝   │       remembered, so that the path has the curve's direction however coarse
//      │   ╔═══+───+       the lattice is, and so that renderers can draw the curve.
//      +═══╝   │   │
#pragma once

#include "sim/ash_stress.h"

namespace ember {

/// From a site to its neighbour in direction d, on the unburnt sheet [m].
[[nodiscard]] PlaneVector edge_vector(const Lattice& lattice, int direction);

/// One step of a path.
struct CrackStep {
    int edge = -1;         ///< direction to the next site; -1: there is none
    PlaneVector offset{};  ///< [m] from the next site to the curve, at a right angle to `heading`
    double advance = 0;    ///< [m] along the curve
};

/// The edge among `allowed` (a mask of directions) that leads forward along the unit vector
/// `heading` and whose end is closest to the line through site + offset.
[[nodiscard]] CrackStep next_step(const Lattice& lattice, unsigned allowed, PlaneVector offset,
                                  PlaneVector heading);

/// Whether a crack may go on from `site`.
[[nodiscard]] bool is_tip(const CrackPaths& cracks, Index site);

/// Puts a tip at the neighbour that `step` leads to. The first curve through a site gives it its
/// offset for good. Nothing happens where another crack has its tip.
void put_tip(const Lattice& lattice, Index site, const CrackStep& step, PlaneVector heading,
             double due, CrackPaths& cracks);

/// Where the curve passes a site [m]: (0, 0) without one.
[[nodiscard]] PlaneVector crack_offset(const CrackPaths& cracks, Index site);

}  // namespace ember
