#include "sim/loads.h"

#include <Eigen/Geometry>

#include "sim/energy.h"
#include "sim/wind.h"

namespace ember {

namespace {

void add_wind(const Vector3& wind, NodeLoads& loads) {
    const std::size_t nodes = loads.drag.size();
    loads.wind.resize(nodes);
    for (std::size_t n = 0; n < nodes; ++n) {
        const Vector3 normal = loads.normal.at(n);
        const Vector3 across = (1.0 - loads.drag_tangential) * wind.dot(normal) * normal;
        const Vector3 force = loads.drag[n] * (across + loads.drag_tangential * wind);
        loads.wind.set(n, force);
        loads.force.set(n, loads.force.at(n) + force);
    }
}

}  // namespace

void gather_loads(const Params& params, const SheetState& sheet, const NodeFire& fire,
                  NodeLoads& loads, double middle) {
    const std::size_t nodes = sheet.mass.size();
    loads.inverse_mass.resize(nodes);
    loads.force.resize(nodes);
    loads.fire.resize(nodes);
    loads.wind.resize(0);
    loads.has_drag = params.world.air_drag > 0;
    loads.drag_tangential = params.world.air_drag_tangential;
    const Vector3 wind = wind_velocity(params.wind, middle);
    const bool burning_near = fire.force.size() == nodes;
    for (std::size_t n = 0; n < nodes; ++n) {
        loads.inverse_mass[n] = sheet.held[n] != 0 ? 0.0 : 1.0 / sheet.mass[n];
        const Vector3 push = burning_near ? fire.force.at(n) : Vector3(Vector3::Zero());
        const double weight = sheet.mass[n] * node_gravity(params.world, sheet, n);
        loads.fire.set(n, push);
        loads.force.set(n, push - Vector3(0, weight, 0));
    }
    if (!loads.has_drag) return;
    loads.drag.resize(nodes);
    for (std::size_t n = 0; n < nodes; ++n) {
        loads.drag[n] = params.world.air_drag * sheet.initial_mass[n] / params.paper.grammage;
    }
    node_normals(sheet, loads.normal);
    if (wind != Vector3::Zero()) add_wind(wind, loads);
}

void node_normals(const SheetState& sheet, Vector3Array& normals) {
    const std::size_t nodes = sheet.mass.size();
    for (std::vector<double>* axis : {&normals.x, &normals.y, &normals.z})
        axis->assign(nodes, 0.0);
    for (const Quad& quad : sheet.quads) {
        const auto corner = [&](int k) {
            return sheet.position.at(static_cast<std::size_t>(quad[static_cast<std::size_t>(k)]));
        };
        const Vector3 area = (corner(2) - corner(0)).cross(corner(3) - corner(1));
        for (const Index node : quad) {
            const auto n = static_cast<std::size_t>(node);
            normals.set(n, normals.at(n) + area);
        }
    }
    for (std::size_t n = 0; n < nodes; ++n) {
        const double length = normals.at(n).norm();
        normals.set(n, length > 0 ? Vector3(normals.at(n) / length) : Vector3(Vector3::Zero()));
    }
}

}  // namespace ember
