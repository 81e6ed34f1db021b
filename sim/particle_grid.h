// The fire particles that sheets can feel, sorted into cells, so that those of a cell and of the
// cells after it in x lie next to each other in memory.
#pragma once

#include <array>
#include <vector>

#include "sim/lanes.h"
#include "sim/params.h"
#include "sim/world_state.h"

namespace ember {

/// An axis-parallel box [m].
struct Box {
    std::array<double, 3> low, high;
};

/// Scratch of the neighbour search.
struct ParticleGrid {
    Box box{};                       ///< that holds every particle in a cell
    double reach = 0;                ///< [m] kernel radius and a little more, for rounding
    double cell = 0;                 ///< [m]
    double per_cell = 0;             ///< [1/m] 1 / cell
    std::array<Index, 3> count{};    ///< cells along x, y, z
    std::vector<Index> begin;        ///< first entry of each cell, cells + 3
    std::vector<Index> cell_of;      ///< cell of each particle; those out of reach: the last
    std::vector<Index> order;        ///< particle numbers, by cell, ascending within a cell
    std::vector<double> x, y, z;     ///< [m] in that order; kLanes more can be read
    std::vector<double> vx, vy, vz;  ///< [m/s] in that order
    std::vector<double> heating;     ///< [K/s] at the kernel's centre, in that order
    std::vector<double> freshness;   ///< e^(-age/heating_time), in that order
    std::vector<double> strength;    ///< [1] in that order
    Index sorted = 0;                ///< particles in cells
    Index listed = 0;                ///< particles in `order`: `sorted`, or all of them

    /// Cell number along `axis` of a coordinate, for which it never decreases.
    [[nodiscard]] Index cell_along(std::size_t axis, double value) const {
        const double at = (value - box.low[axis]) * per_cell;
        if (!(at > 0)) return 0;
        const Index last = count[axis] - 1;
        return at < static_cast<double>(last) ? static_cast<Index>(at) : last;
    }
};

/// Sorts the particles that are within the kernel's radius of the box of all sheets. The others are
/// left out; with `all`, they are listed after the sorted ones. `heating` [K/s]: see
/// particle_heating(). `time` [s]: of the particles' positions.
void sort_particles(const Params& params, double heating, double time, bool all,
                    const std::vector<SheetState>& sheets, const FireState& fire,
                    ParticleGrid& grid);

}  // namespace ember
