// A sheet that is small enough to be solved to rounding, for the tests of integrators.
#pragma once

#include <cmath>

#include "rig.h"

namespace ember::test {

/// It hangs by one edge and swings, damped in its springs and by the air.
inline Params small_swing() {
    Params p = plain(5, 6);
    p.sheet.held = HeldEdge::MainStart;
    p.world.gravity = 9.81;
    p.world.air_drag = 0.1;
    return p;
}

/// Root mean square distance of nodes.
inline double distance(const Vector3Array& p, const Vector3Array& q) {
    double sum = 0;
    for (std::size_t n = 0; n < p.size(); ++n)
        sum += (p.at(n) - q.at(n)).squaredNorm();
    return std::sqrt(sum / static_cast<double>(p.size()));
}

}  // namespace ember::test
