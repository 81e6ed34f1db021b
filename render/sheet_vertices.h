// From views of sheets to vertices: pure, no GL.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/world_view.h"

namespace ember {

/// One node as the sheet shader sees it.
struct SheetVertex {
    float x, y, z;      ///< [m]
    float nx, ny, nz;   ///< unit normal
    float u, v;         ///< place on the unburnt sheet, main and cross direction [mm]
    float progress;     ///< burn progress, see palette.h
    float temperature;  ///< [degC]
    float mass;         ///< share of the initial mass that is left [1]
    float phase;        ///< 0, 1, 2
};

/// Appends the nodes of `sheet`. Normals are area-weighted over the quads of each node.
void append_vertices(const SheetView& sheet, const WorldView& world,
                     std::vector<SheetVertex>& vertices);

/// Appends two triangles per quad, as indices offset by `first_vertex`.
void append_triangles(const SheetView& sheet, std::uint32_t first_vertex,
                      std::vector<std::uint32_t>& indices);

}  // namespace ember
