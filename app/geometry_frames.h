// The geometry of a shot, frame by frame, as other programs want it: plain meshes.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/world_view.h"

namespace ember {

/// One sheet at one time: the nodes that quads use, and the quads.
struct MeshFrame {
    std::vector<std::array<float, 3>> points;  ///< [m], y upwards
    std::vector<std::array<float, 2>> uv;      ///< [1] across and along the sheet, see corner_uv
    std::vector<float> temperature;            ///< [degC]
    std::vector<float> mass;                   ///< [kg]
    std::vector<int> phase;                    ///< 0 unburnt, 1 burning, 2 burnt out
    std::vector<float> age;                    ///< [s] since it caught fire; -1 before
    std::vector<std::array<int, 4>> quads;     ///< counter-clockwise seen against the normal
    bool closed = false;                       ///< a tube
};

/// Texture coordinates of a corner of a quad; around a tube's seam they go on to 1.
[[nodiscard]] std::array<float, 2> corner_uv(const MeshFrame& mesh, std::size_t quad,
                                             std::size_t corner);

/// Several sheets as one mesh.
[[nodiscard]] MeshFrame joined(const std::vector<MeshFrame>& sheets);

/// Fire particles at one time.
struct PointFrame {
    std::vector<std::array<float, 3>> points;  ///< [m]
    std::vector<float> temperature;            ///< [degC]
    std::vector<float> age;                    ///< [s]
    std::vector<std::uint64_t> ids;
};

/// The mesh of a sheet as it is: its vertices are the nodes that quads use, in their order.
[[nodiscard]] MeshFrame mesh_of(const SheetView& sheet, double time);

[[nodiscard]] PointFrame points_of(const ParticleView& particles, double time);

/// What is kept of a frame until the last topology is known: all nodes, and which of them each
/// corner of a quad uses.
struct KeptFrame {
    double time = 0;  ///< [s]
    std::vector<MeshFrame> sheets;
    PointFrame particles;
};
[[nodiscard]] KeptFrame keep_frame(const WorldView& world);

/// `earlier` with the vertices of `last`, a later frame of the same sheet. Cuts only ever split
/// vertices and never change quads, so all corners that a vertex of `last` joins are at one vertex
/// of `earlier`: the one that it was split from.
[[nodiscard]] MeshFrame with_vertices_of(const MeshFrame& last, const MeshFrame& earlier);

}  // namespace ember
