// From views of sheets to vertices: pure, no GL.
//
// Each quad is drawn as a patch of level × level pieces, (level + 1)² vertices of its own. The
// patch is bounded by curves that follow from the positions and normals of two nodes alone, so
// patches meet whatever has been cut, and a coarse lattice looks like a smooth sheet.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/world_view.h"

namespace ember {

/// What changes from picture to picture.
struct SheetVertex {
    float x, y, z;                           ///< [m]
    float nx, ny, nz;                        ///< unit normal
    float charred, burnt, age, temperature;  ///< [mm, mm, s, degC], see sheet_fields.h
    float quantity;                          ///< of the nodes, linear in between
};

/// What changes only with the topology.
struct SheetPoint {
    float u, v;           ///< place on the unburnt sheet, main and cross direction [mm]
    float s, t;           ///< place in the quad, main and cross direction, 0 .. 1
    float along, across;  ///< size of the quad [mm]
    float right, down;    ///< place on the printed page, 0 .. 1
    float grain;          ///< number of the sheet: where on the textures its grain begins
    float edges;          ///< which sides of the quad are edges of the paper, see kTornSide
};

/// Bits of SheetPoint::edges: side k runs from corner k to corner k + 1 of the quad; the bits above
/// them are torn corners of which no side is torn, and then sides at the border of the sheet.
inline constexpr unsigned kTornSide = 1, kTornCorner = 16, kBorderSide = 256;

/// How many pieces a quad is divided into along each side, for so many quads in all that are so
/// many pixels wide in the picture: pieces smaller than 8 pixels cost more than they show.
[[nodiscard]] int patch_level(std::size_t quads, double pixels);

/// How many shells paper is drawn as, one above the other, that is so many pixels thick: enough
/// that torn edges show as a wall, and one, without thickness, where that would be too little to
/// see.
[[nodiscard]] int shell_count(double pixels);

/// Appends the patches of `sheet`. `quantity` has one value per node, or is empty. `ragged`: see
/// edge_shifts(), the same for both.
void append_vertices(const SheetView& sheet, const WorldView& world, int level,
                     std::span<const float> quantity, std::vector<SheetVertex>& vertices,
                     double ragged = 0);
void append_points(const SheetView& sheet, std::size_t number, int level,
                   std::vector<SheetPoint>& points, double ragged = 0);

/// Appends the triangles of `quads` patches, as indices offset by `first_vertex`.
void append_triangles(std::size_t quads, int level, std::uint32_t first_vertex,
                      std::vector<std::uint32_t>& indices);

}  // namespace ember
