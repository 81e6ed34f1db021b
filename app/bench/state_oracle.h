// Whether a state can be true, judged from its arrays alone.
#pragma once

#include <string>

#include "sim/world.h"

namespace ember {

/// Watches one run. Computes for itself what the simulation's own checks say.
class StateOracle {
  public:
    /// To be made from the state before the first tick.
    StateOracle(const Params& params, const WorldState& start);

    /// What is wrong with the state after a tick under `params`, or an empty text: numbers that are
    /// not finite, temperatures outside [air, max(flame limit, start)], mass that is lost, kinetic
    /// energy, energy excess or heat that the ledgers do not account for, more energy in the
    /// integrator's own error than was ever put into the sheet.
    [[nodiscard]] std::string problem(const Params& params, const WorldState& state);

  private:
    [[nodiscard]] std::string bad_number(const WorldState& state) const;
    [[nodiscard]] std::string bad_temperature(const Params& params, const WorldState& state);
    [[nodiscard]] std::string bad_mass(const WorldState& state) const;
    [[nodiscard]] std::string bad_energy(const WorldState& state);
    [[nodiscard]] std::string bad_heat(const Params& params, const WorldState& state) const;
    double coldest_, hottest_;  // [K] allowed
    double initial_mass_ = 0;   // [kg]
    double at_first_,
        height_;         // [J] kinetic and elastic energy, and gravitational energy, at first
    double fallen_ = 0;  // [J] most that gravity has given
};

}  // namespace ember
