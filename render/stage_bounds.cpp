#include "render/stage_bounds.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace ember {
namespace {

Eigen::Vector3d node_at(const SheetView& sheet, Index node) {
    const auto n = static_cast<std::size_t>(node);
    return {sheet.x[n], sheet.y[n], sheet.z[n]};
}

// What a block of sites adds up to.
struct Block {
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();  // area times place
    Eigen::Vector3d vector_area = Eigen::Vector3d::Zero();
    double area = 0;
};

void add_blocks(const SheetView& sheet, Index across, Index along, std::vector<Block>& out) {
    const std::size_t first = out.size();
    out.resize(first + static_cast<std::size_t>(across * along));
    for (const Quad& quad : sheet.quads) {
        const Eigen::Vector3d a = node_at(sheet, quad[0]), b = node_at(sheet, quad[1]);
        const Eigen::Vector3d c = node_at(sheet, quad[2]), d = node_at(sheet, quad[3]);
        const Eigen::Vector3d vector_area = 0.5 * (c - a).cross(d - b);
        const Index site = sheet.site[static_cast<std::size_t>(quad[0])];
        const Index row = site / sheet.column_count, column = site % sheet.column_count;
        const Index block =
            row * across / sheet.row_count * along + column * along / sheet.column_count;
        Block& sum = out[first + static_cast<std::size_t>(block)];
        const double area = vector_area.norm();
        sum.moment += area * 0.25 * (a + b + c + d);
        sum.vector_area += vector_area;
        sum.area += area;
    }
}

}  // namespace

Bounds bounds_of(const WorldView& world) {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(1e30), high = -low;
    for (const SheetView& sheet : world.sheets) {
        for (std::size_t n = 0; n < sheet.x.size(); ++n) {
            if (sheet.initial_mass[n] == 0) continue;  // no paper
            const Eigen::Vector3d at(sheet.x[n], sheet.y[n], sheet.z[n]);
            low = low.cwiseMin(at);
            high = high.cwiseMax(at);
        }
    }
    if (low.x() > high.x()) return {};
    return {(0.5 * (low + high)).cast<float>(), static_cast<float>(0.5 * (high - low).norm())};
}

std::vector<Occluder> gather_occluders(const WorldView& world) {
    std::vector<Occluder> out;
    const auto sheets = static_cast<Index>(world.sheets.size());
    if (sheets == 0) return out;
    const Index each = std::max<Index>(1, kMostOccluders / sheets);
    const Index across = each >= 24 ? 4 : each >= 6 ? 2 : 1;
    std::vector<Block> blocks;
    for (const SheetView& sheet : world.sheets)
        add_blocks(sheet, across, std::max<Index>(1, each / across), blocks);
    for (const Block& b : blocks) {
        if (!(b.area > 0) || out.size() == kMostOccluders) continue;
        const Eigen::Vector3f place = (b.moment / b.area).cast<float>();
        // a folded block faces nowhere in particular, and then counts as facing up
        const Eigen::Vector3d n = b.vector_area.norm() > 0.1 * b.area
                                      ? Eigen::Vector3d(b.vector_area.normalized())
                                      : Eigen::Vector3d(Eigen::Vector3d::UnitY());
        Occluder occluder;
        occluder.place << place, static_cast<float>(b.area);
        occluder.normal << n.cast<float>(), 0.0f;
        out.push_back(occluder);
    }
    return out;
}

Eigen::Matrix4f shadow_from_world(const Bounds& bounds, const Eigen::Vector3f& direction) {
    const Eigen::Vector3f forward = -direction.normalized();
    const Eigen::Vector3f side = std::abs(forward.y()) < 0.99f ? Eigen::Vector3f::UnitY().eval()
                                                               : Eigen::Vector3f::UnitX().eval();
    const Eigen::Vector3f right = forward.cross(side).normalized(), up = right.cross(forward);
    const float radius = std::max(bounds.radius, 1e-3f) * 1.15f;  // a border for the blur
    Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
    matrix.block<1, 3>(0, 0) = right.transpose();
    matrix.block<1, 3>(1, 0) = up.transpose();
    matrix.block<1, 3>(2, 0) = forward.transpose();
    matrix.block<3, 3>(0, 0) *= 0.5f / radius;
    matrix.block<3, 1>(0, 3) =
        Eigen::Vector3f::Constant(0.5f) - matrix.block<3, 3>(0, 0) * bounds.centre;
    return matrix;
}

}  // namespace ember
