// The state of a world: everything that evolves, and nothing else. A snapshot is a copy of it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/types.h"
#include "sim/world_view.h"

namespace ember {

/// Curvatures of a plate without moments (plate.h) [1/m], positive towards the normal; S each, or
/// empty where all are 0. The twist is that of a cell, at the site of its first corner.
struct RestCurvature {
    std::vector<double> main, cross, twist;
};

/// Cracks that follow the stress: see crack_path.h. Arrays over sites, S; empty before the first.
struct CrackPaths {
    std::vector<double> offset_x, offset_z;    ///< [m] from the site to the crack's curve
    std::vector<double> heading_x, heading_z;  ///< unit vector at tips, 0 elsewhere
    std::vector<double> due;                   ///< [s] when a tip may go on
    std::vector<Index> tips;                   ///< sites, in the order in which they were reached
};

/// How the two faces of a sheet that curls differ (curl.h); S each, or empty.
struct FaceDifference {
    std::vector<double> heat;      ///< [K] by how much the half towards the normal is hotter
    std::vector<double> charred;   ///< [1] by how much it is charred more
    std::vector<double> progress;  ///< [1] share of its burning that a node has behind it
};

/// What evolves on one sheet. Node n < site count is the first copy of site n; cuts append copies.
struct SheetState {
    // per node, N
    Vector3Array position;              ///< [m]
    Vector3Array velocity;              ///< [m/s]
    std::vector<double> temperature;    ///< [K]
    std::vector<double> mass;           ///< [kg]
    std::vector<double> initial_mass;   ///< [kg] before burning; shared out when a node splits
    std::vector<double> ignition_time;  ///< [s], +inf before
    std::vector<double> burnout_time;   ///< [s], +inf before
    std::vector<Phase> phase;
    std::vector<Index> site;               ///< lattice site of each node
    std::vector<std::uint8_t> held;        ///< 1: attached, never moves
    std::vector<std::uint8_t> piece_held;  ///< 1: its piece hangs on a held node
    // per lattice site, S
    std::vector<std::uint8_t> glue;    ///< bit d: quads on both sides of edge d share a node
    std::vector<double> relief_until;  ///< [s] no cut at this site before
    RestCurvature rest_curvature;      ///< of a sheet that is a plate
    CrackPaths cracks;
    FaceDifference faces;  ///< of one that curls
    // per lattice row
    std::vector<Index> quiet_ticks;  ///< ticks that the row has rested, see sleep.h
    // per spring slot, 6×S (see lattice.h)
    std::vector<double> rest_length;  ///< [m]
    // per quad, Q
    std::vector<Quad> quads;
    std::uint64_t topology_version = 0;
};

/// Fire particles, P; a particle keeps its id for life.
struct FireState {
    Vector3Array position;             ///< [m]
    Vector3Array velocity;             ///< [m/s]
    std::vector<double> temperature;   ///< [K]
    std::vector<double> strength;      ///< [1] relative heating
    std::vector<double> birth, death;  ///< [s]
    std::vector<std::uint64_t> id;     ///< (emitter, number), hashed

    [[nodiscard]] std::size_t size() const { return id.size(); }
};

/// Calls visit(array) for every array of the particles.
template <class Visitor>
void for_each_array(FireState& fire, Visitor&& visit) {
    visit(fire.position.x), visit(fire.position.y), visit(fire.position.z);
    visit(fire.velocity.x), visit(fire.velocity.y), visit(fire.velocity.z);
    visit(fire.temperature), visit(fire.strength), visit(fire.birth), visit(fire.death);
    visit(fire.id);
}

/// Where mechanical energy went since t = 0 [J]. See energy.h.
struct EnergyLedger {
    double initial = 0;                                  ///< kinetic + elastic + gravitational
    double kinetic = 0, elastic = 0, gravitational = 0;  ///< now
    double work_fire = 0;                                ///< by fire particles and a hand
    double work_wind = 0;                                ///< by the air's own motion
    double change_scheme = 0;                            ///< see TickWork::scheme
    double initial_gravitational = 0;                    ///< its part in `initial`
    double scheme_settled = 0;                           ///< change_scheme after the last tick
    double unaccounted = 0;                              ///< after the last tick
    double largest = 0;                                  ///< term of the ledger so far
    double loss_damping = 0, loss_drag = 0;              ///< in springs, to the air
    double loss_sleep = 0;                               ///< of rows that fell asleep
    double work_contact = 0;                             ///< by contact; < 0: taken away
    double change_mass = 0;                              ///< mass burnt off and springs weakened
    double change_rest_length = 0;                       ///< shrinking
    double change_curvature = 0;                         ///< of plates at rest: curl, set
    double change_topology = 0;                          ///< cuts
    double change_edit = 0;                              ///< live parameters
};

/// Where heat went since t = 0 [J]. See heat.h.
struct HeatLedger {
    double stored = 0;                         ///< above ambient, now
    double given_fire = 0, given_burning = 0;  ///< by particles and by burning itself
    double lost_air = 0, lost_held = 0;        ///< to the air, to held edges
    double change_edit = 0;                    ///< live parameters: another heat capacity
};

/// Totals since t = 0.
struct Totals {
    std::int64_t cuts = 0;
    std::int64_t ignitions = 0, burnouts = 0;
    std::int64_t retries = 0;
    double burnt_mass = 0;  ///< [kg] gone up in flames
};

struct WorldState {
    std::uint64_t tick = 0;
    double time = 0;              ///< [s]
    std::int64_t refinement = 0;  ///< sub-steps are 2^refinement times smaller than the bound asks
    std::vector<SheetState> sheets;
    FireState fire;
    EnergyLedger energy;
    HeatLedger heat;
    Totals totals;
};

/// Calls visit(name, array) for every array of the state, and visit(name, value) for every single
/// number: the one list behind hashing and checkpoints.
template <class State, class Visitor>
void for_each_field(State& state, Visitor&& visit);

/// 64-bit hash of every field of the state, independent of the platform's memory layout.
[[nodiscard]] std::uint64_t hash_of(const WorldState& state);

template <class Visitor, class Vectors>
void visit_vectors(Visitor& visit, const char* name, Vectors& v) {
    visit(name, v.x), visit(name, v.y), visit(name, v.z);
}

template <class Sheet, class Visitor>
void for_each_sheet_field(Sheet& sheet, Visitor&& visit) {
    visit_vectors(visit, "sheet.position", sheet.position);
    visit_vectors(visit, "sheet.velocity", sheet.velocity);
    visit("sheet.temperature", sheet.temperature), visit("sheet.mass", sheet.mass);
    visit("sheet.initial_mass", sheet.initial_mass);
    visit("sheet.ignition_time", sheet.ignition_time);
    visit("sheet.burnout_time", sheet.burnout_time), visit("sheet.phase", sheet.phase);
    visit("sheet.site", sheet.site), visit("sheet.held", sheet.held);
    visit("sheet.piece_held", sheet.piece_held), visit("sheet.glue", sheet.glue);
    visit("sheet.relief_until", sheet.relief_until);
    visit("sheet.quiet_ticks", sheet.quiet_ticks);
    visit("sheet.rest_length", sheet.rest_length), visit("sheet.quads", sheet.quads);
    visit("sheet.topology_version", sheet.topology_version);
    auto& cracks = sheet.cracks;
    if (!cracks.due.empty()) {  // not among the fields of a sheet without
        visit("cracks.offset_x", cracks.offset_x), visit("cracks.offset_z", cracks.offset_z);
        visit("cracks.heading_x", cracks.heading_x);
        visit("cracks.heading_z", cracks.heading_z), visit("cracks.due", cracks.due);
        visit("cracks.tips", cracks.tips);
    }
    auto& rest = sheet.rest_curvature;
    if (rest.main.empty()) return;  // not among the fields of a sheet without
    visit("sheet.rest_curvature", rest.main), visit("sheet.rest_curvature", rest.cross);
    visit("sheet.rest_curvature", rest.twist);
    visit("sheet.faces", sheet.faces.heat), visit("sheet.faces", sheet.faces.charred);
    visit("sheet.faces", sheet.faces.progress);
}

template <class State, class Visitor>
void for_each_ledger_field(State& s, Visitor&& visit) {
    auto& e = s.energy;
    visit("energy.initial", e.initial), visit("energy.kinetic", e.kinetic);
    visit("energy.elastic", e.elastic), visit("energy.gravitational", e.gravitational);
    visit("energy.work_fire", e.work_fire), visit("energy.change_scheme", e.change_scheme),
        visit("energy.unaccounted", e.unaccounted);
    visit("energy.work_wind", e.work_wind);
    visit("energy.initial_gravitational", e.initial_gravitational);
    visit("energy.scheme_settled", e.scheme_settled), visit("energy.largest", e.largest),
        visit("energy.loss_damping", e.loss_damping);
    visit("energy.loss_drag", e.loss_drag), visit("energy.loss_sleep", e.loss_sleep),
        visit("energy.work_contact", e.work_contact);
    visit("energy.change_mass", e.change_mass);
    visit("energy.change_rest_length", e.change_rest_length);
    visit("energy.change_topology", e.change_topology), visit("energy.change_edit", e.change_edit);
    auto& h = s.heat;
    visit("heat.stored", h.stored), visit("heat.given_fire", h.given_fire);
    visit("heat.given_burning", h.given_burning), visit("heat.lost_air", h.lost_air);
    visit("heat.lost_held", h.lost_held);
    visit("heat.change_edit", h.change_edit);
    auto& t = s.totals;
    visit("totals.cuts", t.cuts), visit("totals.ignitions", t.ignitions);
    visit("totals.burnouts", t.burnouts), visit("totals.retries", t.retries);
    visit("totals.burnt_mass", t.burnt_mass);
}

template <class State, class Visitor>
void for_each_field(State& s, Visitor&& visit) {
    visit("tick", s.tick), visit("time", s.time), visit("refinement", s.refinement);
    for (auto& sheet : s.sheets) {
        for_each_sheet_field(sheet, visit);
        if (!sheet.rest_curvature.main.empty())
            visit("energy.change_curvature", s.energy.change_curvature);
    }
    visit_vectors(visit, "fire.position", s.fire.position);
    visit_vectors(visit, "fire.velocity", s.fire.velocity);
    visit("fire.temperature", s.fire.temperature), visit("fire.strength", s.fire.strength);
    visit("fire.birth", s.fire.birth), visit("fire.death", s.fire.death);
    visit("fire.id", s.fire.id);
    for_each_ledger_field(s, visit);
}

}  // namespace ember
