// The swing problem: a soft sheet held by one edge falls from the horizontal.
#pragma once

#include "rig.h"

namespace ember::test {

/// The parameters of presets/bench/swing.toml for a lattice of the given numbers of nodes; finer
/// ones have the same sheet and the paper's stiffness per node mass.
inline Params swing(int node_rows = 32, int node_columns = 48) {
    Params p = plain(node_rows - 1, node_columns - 1);
    p.sheet.width = 0.2034375;
    p.sheet.height = 0.2908125;
    p.sheet.border = Border::Uniform;
    p.sheet.held = HeldEdge::MainStart;
    p.springs.stiffness_law = StiffnessLaw::PerNodeMass;
    p.world.gravity = 9.81;
    return p;
}

}  // namespace ember::test
