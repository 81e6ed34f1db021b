#include "render/sheet_vertices.h"

#include <Eigen/Geometry>

#include "render/palette.h"

namespace ember {
namespace {

std::vector<Eigen::Vector3f> node_normals(const SheetView& sheet) {
    std::vector<Eigen::Vector3f> normals(sheet.x.size(), Eigen::Vector3f::Zero());
    const auto at = [&](Index node) {
        const auto n = static_cast<std::size_t>(node);
        return Eigen::Vector3f(static_cast<float>(sheet.x[n]), static_cast<float>(sheet.y[n]),
                               static_cast<float>(sheet.z[n]));
    };
    for (const Quad& q : sheet.quads) {
        const Eigen::Vector3f area = (at(q[2]) - at(q[0])).cross(at(q[3]) - at(q[1]));
        for (const Index node : q)
            normals[static_cast<std::size_t>(node)] += area;
    }
    for (Eigen::Vector3f& n : normals) {
        const float length = n.norm();
        n = length > 0 ? Eigen::Vector3f(n / length) : Eigen::Vector3f(Eigen::Vector3f::UnitZ());
    }
    return normals;
}

}  // namespace

void append_vertices(const SheetView& sheet, const WorldView& world,
                     std::vector<SheetVertex>& vertices) {
    const std::vector<Eigen::Vector3f> normals = node_normals(sheet);
    const Index cells_along = sheet.column_count - 1;
    const Index cells_across = sheet.closed ? sheet.row_count : sheet.row_count - 1;
    const double mm_along = 1e3 * sheet.height / cells_along;
    const double mm_across = 1e3 * sheet.width / cells_across;
    for (std::size_t n = 0; n < sheet.x.size(); ++n) {
        const Index row = sheet.site[n] / sheet.column_count;
        const Index column = sheet.site[n] % sheet.column_count;
        // of what is no paper nothing is drawn
        const bool paper = sheet.initial_mass[n] > 0;
        const double left = paper ? sheet.mass[n] / sheet.initial_mass[n] : 1.0;
        const double burnt = (1.0 - left) / (1.0 - world.residual_mass);
        const double progress = burn_progress(sheet.phase[n], sheet.temperature[n], world.ignition,
                                              burnt, world.time - sheet.burnout_time[n]);
        vertices.push_back({static_cast<float>(sheet.x[n]), static_cast<float>(sheet.y[n]),
                            static_cast<float>(sheet.z[n]), normals[n].x(), normals[n].y(),
                            normals[n].z(), static_cast<float>(mm_along * column),
                            static_cast<float>(mm_across * row), static_cast<float>(progress),
                            static_cast<float>(sheet.temperature[n] - 273.15),
                            static_cast<float>(left), static_cast<float>(sheet.phase[n])});
    }
}

void append_triangles(const SheetView& sheet, std::uint32_t first_vertex,
                      std::vector<std::uint32_t>& indices) {
    for (const Quad& q : sheet.quads) {
        for (const std::size_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) {
            indices.push_back(first_vertex + static_cast<std::uint32_t>(q[corner]));
        }
    }
}

}  // namespace ember
