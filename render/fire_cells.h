// How much fire is where, by coarse cells of the world. Pure, no GL.
#pragma once

#include <Eigen/Core>
#include <array>
#include <map>

#include "sim/world_view.h"

namespace ember {

/// Share of its life that a particle has lived, 0 .. 1.
[[nodiscard]] double particle_life(const WorldView& world, std::size_t particle);

/// Heat u of a particle: 1 at birth temperature, 0 at ambient.
[[nodiscard]] double particle_heat(const WorldView& world, std::size_t particle);

/// Particles shared out to the corners of cells, in proportion to how near they are, so that
/// nothing jumps when one moves; and coming and going without a jump as they are born and die.
class FireCells {
  public:
    static constexpr double kSize = 0.08;  ///< [m] of a cell

    /// What a corner has got.
    struct Corner {
        double x = 0, y = 0, z = 0;  ///< [m] places of its particles, times what each shines
        double light = 0;            ///< [particles] that shine as much, at birth temperature
        double gas = 0;              ///< [particles] hot or not
    };
    using Corners = std::map<std::array<int, 3>, Corner>;

    explicit FireCells(const WorldView& world);
    [[nodiscard]] const Corners& corners() const { return corners_; }
    /// [particles] in a cell around `place` [m], less those of its borders than of its middle;
    /// nothing farther away than two cells counts.
    [[nodiscard]] double gas_at(const Eigen::Vector3d& place) const;

  private:
    Corners corners_;
};

}  // namespace ember
