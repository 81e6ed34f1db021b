// A burning sheet that is staged, not simulated: everything the renderer reads, known in advance.
#pragma once

#include <cstdint>
#include <vector>

#include "render/fire_cells.h"
#include "sim/world_view.h"

namespace ember::test {

/// Owns the arrays that view() points into. Change them freely before calling view().
struct StagedWorld {
    int rows = 0, columns = 0;  ///< lattice sites
    double width = 0.210, height = 0.297, time = 5.0;
    std::vector<double> x, y, z, rest, temperature, mass, initial_mass;
    std::vector<double> ignition_time, burnout_time;
    std::vector<Phase> phase;
    std::vector<Index> site;
    std::vector<Quad> quads;
    std::uint64_t topology_version = 1;
    bool ground = true, lighter_lit = false;

    std::vector<double> fire_x, fire_y, fire_z, fire_vx, fire_vy, fire_vz;
    std::vector<double> fire_temperature, fire_birth, fire_death;
    std::vector<std::uint64_t> fire_id;

    [[nodiscard]] std::size_t node(int row, int column) const {
        return static_cast<std::size_t>(row * columns + column);
    }
    void add_particle(const Vector3& position, double kelvin);
    [[nodiscard]] WorldView view() const;
};

inline constexpr double kAmbient = 293.15, kIgnition = 1041.15, kFlame = 785.15;  // [K]
inline constexpr double kBurntOut = 0.13,
                        kFront = 0.16;  // [m] from the corner, see burning_sheet()

/// A flat unburnt sheet hanging in the plane z = 0 at ambient temperature, its upper edge (column
/// 0) at y = 0.45 m; no particles.
[[nodiscard]] StagedWorld hanging_sheet(int rows, int columns);

/// The sheet of hanging_sheet(), bent, with a front around its lower left corner: burnt out within
/// 130 mm, burning up to 160 mm, scorched just ahead; `particles` particles above the front.
[[nodiscard]] StagedWorld burning_sheet(int rows, int columns, int particles);

/// So many particles at one place, at birth temperature.
[[nodiscard]] FireCells fire_at(const Vector3& place, int particles);

}  // namespace ember::test
