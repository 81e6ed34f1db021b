// Contact: paper rests on the ground, on other paper and on itself.
//
// While anything is near anything else a tick is divided into intervals of contact.interval at
// most. At the start of each, contacts are found among the near pairs (contact_pairs.h,
// contact_geometry.h) and the impulses that they need (contact_solver.h); these act as forces that
// are constant during the interval, like gravity, so that every integrator sees a load like any
// other, no node is put anywhere, and the work of contact is force · way.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/contact_pairs.h"
#include "sim/contact_solver.h"
#include "sim/mechanics.h"

namespace ember {

/// A sheet that may touch something.
struct ContactSheet {
    const Lattice* lattice;
    double gap;  ///< [m] to its neighbours at the start: it never keeps farther away than that
    SheetState* sheet;
    NodeLoads* loads;            ///< gathered for this tick
    const std::uint8_t* asleep;  ///< of each row; nullptr while nothing sleeps
};

/// Scratch of the contacts of a world.
struct ContactScratch {
    std::vector<ContactSheet> sheets;  ///< to be set before find_contacts()
    std::vector<SheetInSpace> shapes;
    NearThings near;
    std::vector<std::vector<Index>> body_of;  ///< of each node of each sheet, kNone: none
    std::vector<SheetNode> owner;             ///< of each body
    std::vector<Vector3> start;               ///< [m/s] of each body at the start of the interval
    std::vector<Vector3> other_force;         ///< [N] on each body without contact
    ContactBodies bodies;
    std::vector<Contact> contacts;
    /// [kg m/s] what the contact of each near thing needed in the last interval of the tick: first
    /// those of the ground, then of quads, then of edges. The next one begins with it.
    std::vector<Vector3> needed;
};

/// Distance that sheets keep [m]: contact.thickness, or the caliper where that is more.
[[nodiscard]] double contact_thickness(const Params& params);

/// Finds what may touch in a tick of `dt` [s]. Returns into how many intervals the tick has to be
/// divided: 1 when nothing is near, and then nothing else is done. Sheets that have something near
/// get NodeLoads::contact, which others leave empty; only they need to be moved by intervals.
std::int64_t find_contacts(const Params& params, double dt, ContactScratch& scratch,
                           StepCounters& counters);

/// Sets the contact forces on all sheets for the next `interval` [s], in NodeLoads::contact and
/// NodeLoads::force. Sleeping rows are not moved, but those that something strikes wake next tick.
void press_contacts(const Params& params, double interval, ContactScratch& scratch,
                    StepCounters& counters);

}  // namespace ember
