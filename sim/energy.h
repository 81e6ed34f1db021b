// The mechanical energy of the world and the ledger of where it went.
#pragma once

#include "sim/parallel.h"
#include "sim/params.h"
#include "sim/spring_network.h"
#include "sim/world_state.h"

namespace ember {

/// Mechanical energy [J].
struct MechanicalEnergy {
    double kinetic = 0, elastic = 0, gravitational = 0;
    [[nodiscard]] double total() const { return kinetic + elastic + gravitational; }
    void operator+=(const MechanicalEnergy& e) {
        kinetic += e.kinetic, elastic += e.elastic, gravitational += e.gravitational;
    }
};

/// The energy of one sheet: ½ Σ m v², ½ Σ k (L - l)², Σ m g y. `rows` is scratch. The same bits for
/// any number of threads.
[[nodiscard]] MechanicalEnergy sheet_energy(const Lattice& lattice, const WorldParams& world,
                                            const SheetState& sheet, const SpringNetwork& network,
                                            ThreadPool& pool, std::vector<MechanicalEnergy>& rows);

/// By how much the ledger fails to account for the present energy [J]; positive: energy from
/// nowhere. `scale` receives the largest of its terms.
[[nodiscard]] double unaccounted_energy(const EnergyLedger& ledger, double& scale);

/// Share of the largest term so far by which energy may exceed the ledger.
inline constexpr double kEnergyMargin = 1e-3;

/// Compares the ledger after a tick with that before and takes the result into it. A tick may use
/// up half of what is left of the margin, so that a slow drift is refined away before it is all
/// used, and no tick has to pay for the ones before it. Returns false when it used more, or when
/// the integrator would have to hold more energy (TickWork::scheme) than was ever put in: beyond
/// its step bound a leapfrog method conserves an energy that allows any growth.
[[nodiscard]] bool settle(EnergyLedger& ledger);

}  // namespace ember
