#include "sim/loads.h"

#include <Eigen/Geometry>

#include "sim/vectorise.h"
#include "sim/wind.h"

namespace ember {

namespace {

// Inverse masses, and what pulls down; a node of a piece that is held feels `held_gravity`.
EMBER_VECTORISED void weigh(std::ptrdiff_t count, const double* __restrict mass,
                            const std::uint8_t* __restrict held,
                            const std::uint8_t* __restrict piece_held, double gravity,
                            double held_gravity, const double* __restrict push,
                            double* __restrict inverse_mass, double* __restrict down) {
    for (std::ptrdiff_t n = 0; n < count; ++n) {
        const double inverse = 1.0 / mass[n];
        inverse_mass[n] = held[n] != 0 ? 0.0 : inverse;
        down[n] = push[n] - mass[n] * (piece_held[n] != 0 ? held_gravity : gravity);
    }
}

EMBER_VECTORISED void find_drag(std::ptrdiff_t count, const double* __restrict initial_mass,
                                double drag, double grammage, double* __restrict to) {
    for (std::ptrdiff_t n = 0; n < count; ++n)
        to[n] = drag * initial_mass[n] / grammage;
}

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
    if (fire.force.size() == nodes) {
        loads.fire = fire.force;
    } else {
        for (std::vector<double>* axis : {&loads.fire.x, &loads.fire.y, &loads.fire.z})
            axis->assign(nodes, 0.0);
    }
    loads.force.x = loads.fire.x;
    loads.force.z = loads.fire.z;
    const auto count = static_cast<std::ptrdiff_t>(nodes);
    weigh(count, sheet.mass.data(), sheet.held.data(), sheet.piece_held.data(),
          params.world.gravity, params.world.gravity_while_held(), loads.fire.y.data(),
          loads.inverse_mass.data(), loads.force.y.data());
    if (!loads.has_drag) return;
    loads.drag.resize(nodes);
    find_drag(count, sheet.initial_mass.data(), params.world.air_drag, params.paper.grammage,
              loads.drag.data());
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
