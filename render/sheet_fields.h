// What the look of burning paper depends on, per lattice site: pure, no GL.
#pragma once

#include <vector>

#include "render/front_distance.h"
#include "sim/world_view.h"

namespace ember {

/// One site. Smooth in space, so that it can be interpolated; copies of a cut node share it.
struct SiteFields {
    float charred;      ///< [mm] behind the line where paper turns to char; negative ahead of it
    float burnt;        ///< [mm] behind the line where char burns out, the ember line
    float age;          ///< [s] since it burnt out; negative before
    float temperature;  ///< [degC]
};

[[nodiscard]] SiteGrid site_grid(const SheetView& sheet);

/// Fields of every site. The char line is where the paper ignited: behind it by the time since,
/// ahead of it by the temperature that the fire has already brought there. Paper that is warmed
/// but has no front near it scorches as if the front were as far away as that warmth means.
[[nodiscard]] std::vector<SiteFields> site_fields(const SheetView& sheet, const WorldView& world);

inline constexpr Index kFieldBorder = 3;

/// Fields of every site with a border of kFieldBorder sites around them in which they go on
/// smoothly: around the seam of a tube, straight on elsewhere.
struct FieldGrid {
    Index columns = 0;               ///< with both borders
    std::vector<SiteFields> fields;  ///< row-major, with both borders
    [[nodiscard]] const SiteFields& at(Index row, Index column) const {
        return fields[static_cast<std::size_t>((row + kFieldBorder) * columns + column +
                                               kFieldBorder)];
    }
};

[[nodiscard]] FieldGrid make_field_grid(const SheetView& sheet, const WorldView& world);

/// Fields at the place (s, t) along columns and rows, in cells from the first corner of the cell
/// (row, column), of which it may lie up to half a cell outside: the uniform cubic B-spline of the
/// sites around. Twice differentiable, so no cell shows.
[[nodiscard]] SiteFields smooth_fields(const FieldGrid& grid, Index row, Index column, float s,
                                       float t);

}  // namespace ember
