#include "sim/energy.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "sim/spring_forces.h"

namespace ember {

void add_energy(const Lattice& lattice, const WorldParams& world, const SheetState& sheet,
                const SpringNetwork& network, MechanicalEnergy& energy) {
    for (std::size_t n = 0; n < sheet.mass.size(); ++n) {
        energy.kinetic += 0.5 * sheet.mass[n] * sheet.velocity.at(n).squaredNorm();
        energy.gravitational += sheet.mass[n] * node_gravity(world, sheet, n) * sheet.position.y[n];
    }
    energy.elastic += elastic_energy(lattice, sheet, network);
}

double unaccounted_energy(const EnergyLedger& e, double& scale) {
    const double now = e.kinetic + e.elastic + e.gravitational;
    const double changes = e.work_fire + e.change_ground + e.change_mass + e.change_rest_length +
                           e.change_topology + e.change_edit;
    const double losses = e.loss_damping + e.loss_drag;
    // potential energy counts by its change, as its zero is arbitrary
    const double fallen = e.gravitational + e.elastic + e.kinetic - e.initial;
    scale = 0.0;
    for (const double term :
         {e.kinetic, e.elastic, fallen, e.work_fire, losses, e.change_ground, e.change_mass,
          e.change_rest_length, e.change_topology, e.change_edit}) {
        scale = std::max(scale, std::abs(term));
    }
    return now - (e.initial + changes - losses);
}

}  // namespace ember
