// Scratch of a world: its contents mean nothing between steps and are never saved or hashed.
#pragma once

#include <vector>

#include "sim/active_nodes.h"
#include "sim/contact.h"
#include "sim/curl.h"
#include "sim/energy.h"
#include "sim/fire_coupling.h"
#include "sim/heat.h"
#include "sim/integrator.h"
#include "sim/lattice.h"
#include "sim/plate_forces.h"
#include "sim/sleep.h"
#include "sim/spring_forces.h"
#include "sim/spring_network.h"
#include "sim/stability.h"
#include "sim/world_state.h"

namespace ember {

/// Derived data and scratch of one sheet.
struct SheetWorkspace {
    Lattice lattice;        ///< never changes
    double gap = 0;         ///< [m] to its neighbours at the start; never changes
    SpringNetwork network;  ///< follows the sheet's topology and masses
    Plate plate;            ///< likewise; empty without rigidity
    PlateForces plate_forces;
    CurlScratch curl;
    NodeLoads loads;
    AwakeRows awake;                     ///< rows that are moved in this tick
    StepControl control;                 ///< how the tick is divided
    std::int64_t contact_intervals = 1;  ///< that the sheet needs when it touches something
    SpringForces forces;
    OldRows old_rows;
    StabilityScratch stability;
    std::vector<MechanicalEnergy> row_energy;
    IntegratorScratch integration;
    HeatScratch heat;
    ActiveNodes active;            ///< follows the sheet's phases
    std::vector<Index> burnt_out;  ///< sites that burnt out in this tick
};

struct Workspace {
    std::vector<SheetWorkspace> sheets;
    std::vector<LighterParams> lighters;  ///< follow the parameters
    CouplingScratch coupling;
    std::vector<NodeTiles> tiles;            ///< of each sheet, once there is fire
    std::vector<const ActiveNodes*> active;  ///< of each sheet; nullptr to look at every node
    std::vector<const Lattice*> lattices;    ///< of each sheet
    std::vector<NodeFire> fire;              ///< what the fire gives to each sheet in this tick
    ContactScratch contact;
    WorldState before;  ///< the state at the start of the tick, for rolling back
};

}  // namespace ember
