#include "app/geometry_frames.h"

#include <algorithm>

#include "sim/units.h"

namespace ember {
namespace {

std::array<float, 3> point(double x, double y, double z) {
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

void put_node(MeshFrame& mesh, const SheetView& sheet, std::size_t n, double time) {
    mesh.points.push_back(point(sheet.x[n], sheet.y[n], sheet.z[n]));
    const Index row = sheet.site[n] / sheet.column_count,
                column = sheet.site[n] % sheet.column_count;
    const int last_row = std::max(sheet.row_count - (sheet.closed ? 0 : 1), 1);
    mesh.uv.push_back(
        {static_cast<float>(row) / static_cast<float>(last_row),
         static_cast<float>(column) / static_cast<float>(std::max(sheet.column_count - 1, 1))});
    mesh.temperature.push_back(static_cast<float>(unit::celsius.from_si(sheet.temperature[n])));
    mesh.mass.push_back(static_cast<float>(sheet.mass[n]));
    mesh.phase.push_back(static_cast<int>(sheet.phase[n]));
    const double lit = sheet.ignition_time[n];
    mesh.age.push_back(lit <= time ? static_cast<float>(time - lit) : -1.0f);
}

}  // namespace

MeshFrame mesh_of(const SheetView& sheet, double time) {
    std::vector<int> vertex(sheet.x.size(), -1);
    for (const Quad& quad : sheet.quads) {
        for (const Index node : quad)
            vertex[static_cast<std::size_t>(node)] = 0;
    }
    MeshFrame mesh;
    mesh.closed = sheet.closed;
    for (std::size_t n = 0; n < vertex.size(); ++n) {
        if (vertex[n] < 0) continue;
        vertex[n] = static_cast<int>(mesh.points.size());
        put_node(mesh, sheet, n, time);
    }
    mesh.quads.reserve(sheet.quads.size());
    for (const Quad& quad : sheet.quads) {
        std::array<int, 4>& corners = mesh.quads.emplace_back();
        for (std::size_t c = 0; c < 4; ++c)
            corners[c] = vertex[static_cast<std::size_t>(quad[c])];
    }
    return mesh;
}

std::array<float, 2> corner_uv(const MeshFrame& mesh, std::size_t quad, std::size_t corner) {
    std::array<float, 2> uv = mesh.uv[static_cast<std::size_t>(mesh.quads[quad][corner])];
    if (!mesh.closed) return uv;
    for (const int vertex : mesh.quads[quad]) {
        if (mesh.uv[static_cast<std::size_t>(vertex)][0] - uv[0] > 0.5f) {
            uv[0] += 1;
            break;
        }
    }
    return uv;
}

MeshFrame joined(const std::vector<MeshFrame>& sheets) {
    MeshFrame all;
    const auto append = [](auto& to, const auto& from) {
        to.insert(to.end(), from.begin(), from.end());
    };
    for (const MeshFrame& sheet : sheets) {
        const int first = static_cast<int>(all.points.size());
        append(all.points, sheet.points), append(all.uv, sheet.uv);
        append(all.temperature, sheet.temperature), append(all.mass, sheet.mass);
        append(all.phase, sheet.phase), append(all.age, sheet.age);
        for (std::array<int, 4> quad : sheet.quads) {
            for (int& corner : quad)
                corner += first;
            all.quads.push_back(quad);
        }
        all.closed = all.closed || sheet.closed;
    }
    return all;
}

PointFrame points_of(const ParticleView& particles, double time) {
    PointFrame frame;
    for (std::size_t i = 0; i < particles.x.size(); ++i) {
        frame.points.push_back(point(particles.x[i], particles.y[i], particles.z[i]));
        frame.temperature.push_back(
            static_cast<float>(unit::celsius.from_si(particles.temperature[i])));
        frame.age.push_back(static_cast<float>(time - particles.birth[i]));
        frame.ids.push_back(particles.id[i]);
    }
    return frame;
}

KeptFrame keep_frame(const WorldView& world) {
    KeptFrame frame{world.time, {}, points_of(world.particles, world.time)};
    for (const SheetView& sheet : world.sheets)
        frame.sheets.push_back(mesh_of(sheet, world.time));
    return frame;
}

MeshFrame with_vertices_of(const MeshFrame& last, const MeshFrame& earlier) {
    std::vector<std::size_t> from(last.points.size());
    for (std::size_t q = 0; q < last.quads.size(); ++q) {
        for (std::size_t c = 0; c < 4; ++c)
            from[static_cast<std::size_t>(last.quads[q][c])] =
                static_cast<std::size_t>(earlier.quads[q][c]);
    }
    MeshFrame mesh;
    mesh.closed = last.closed;
    mesh.quads = last.quads;
    for (const std::size_t vertex : from) {
        mesh.points.push_back(earlier.points[vertex]);
        mesh.uv.push_back(earlier.uv[vertex]);
        mesh.temperature.push_back(earlier.temperature[vertex]);
        mesh.mass.push_back(earlier.mass[vertex]);
        mesh.phase.push_back(earlier.phase[vertex]);
        mesh.age.push_back(earlier.age[vertex]);
    }
    return mesh;
}

}  // namespace ember
