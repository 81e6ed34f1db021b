// What others may read of a world: spans, never anything to write through.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/types.h"

namespace ember {

using Quad = std::array<Index, 4>;  ///< node numbers, counter-clockwise seen against +normal

enum class SpringKind : std::uint8_t { Structural, Diagonal, Bending };

/// One spring as drawn and exported.
struct SpringSegment {
    Index a, b;  ///< nodes
    SpringKind kind;
    double stiffness = 1;  ///< [1] unburnt, over the mean of the sheet's springs of its direction
    double stress = 0;     ///< [Pa] in the paper that a structural spring stands for; else 0
};

/// One sheet. Arrays over nodes have N entries, the first rows*columns of them in site order.
struct SheetView {
    Index row_count = 0, column_count = 0;  ///< lattice sites: cross (z) and main (x) direction
    bool closed = false;                    ///< rows wrap around: a tube
    double width = 0, height = 0;           ///< [m] cross and main size at rest
    std::span<const double> x, y, z;        ///< position [m], N
    std::span<const double> vx, vy, vz;     ///< velocity [m/s], N
    std::span<const double> temperature;    ///< [K], N
    std::span<const double> mass;           ///< [kg], N
    std::span<const double> initial_mass;   ///< [kg], N; 0 where the sheet has no paper
    std::span<const double> ignition_time;  ///< [s], N; when the node caught fire, else +inf
    std::span<const double> burnout_time;   ///< [s], N; when the node burnt out, else +inf
    std::span<const Phase> phase;           ///< N
    std::span<const Index> site;            ///< N; row * column_count + column of each node
    std::span<const Quad> quads;            ///< constant count
    /// From each site to the curve of the crack through it, in the main and cross direction [m];
    /// rows*columns, or empty.
    std::span<const double> crack_x, crack_z;
    std::uint64_t topology_version = 0;  ///< changes when quads or springs change
};

/// Fire particles. Arrays over particles have P entries, oldest first within an emitter.
struct ParticleView {
    std::span<const double> x, y, z;       ///< [m]
    std::span<const double> vx, vy, vz;    ///< [m/s]
    std::span<const double> temperature;   ///< [K]
    std::span<const double> birth, death;  ///< [s]
    std::span<const std::uint64_t> id;     ///< stable while the particle lives; a random seed
};

/// One lighter.
struct LighterView {
    Vector3 position = Vector3::Zero();  ///< [m]
    bool lit = false;
};

/// Valid until the world is stepped, restored or destroyed.
struct WorldView {
    std::uint64_t tick = 0;
    double time = 0;              ///< [s]
    double ambient = 0;           ///< [K]
    double ignition = 0;          ///< [K]
    double residual_mass = 0;     ///< [1] share of a node's mass that stays as ash
    double burning_time = 0;      ///< [s] from catching fire to burning out
    double fire_temperature = 0;  ///< [K] of a particle at birth
    double caliper = 0;           ///< [m] thickness of the paper
    bool ground = false;          ///< a floor at y = 0
    std::vector<LighterView> lighters;
    std::vector<SheetView> sheets;
    ParticleView particles;
};

}  // namespace ember
