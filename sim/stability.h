// How large a sub-step may be: a bound on the fastest motion of the lattice, computed, not guessed.
#pragma once

#include "sim/integrator.h"
#include "sim/spring_network.h"

namespace ember {

/// Largest |λ| dt for which RK4 is stable at every damping ratio; 2.83 holds only undamped.
inline constexpr double kRungeKuttaLimit = 2.6;

/// Upper bound on |λ| [1/s] of the linearised motion of the sheet as it stands, by block
/// Gershgorin on the mass-scaled stiffness and damping matrices. With D_i the 3×3 block of node i,
///
///     ω² <= max_i ( |D_i| / m_i + Σ_j |K_ij| / sqrt(m_i m_j) ),   γ likewise,
///     |λ| <= (γ + sqrt(γ² + 4 ω²)) / 2.
///
/// Stretch enters through the transverse stiffness k (1 - l/L) of each spring, taken by its size;
/// held nodes do not move and drop out. Valid for any mass, stretch and topology.
[[nodiscard]] double spectral_bound(const Lattice& lattice, const SheetState& sheet,
                                    const SpringNetwork& network, const NodeLoads& loads);

/// Sub-steps that a tick of `dt` [s] needs: at least `least`, and |λ| dt <= safety · 2.6 each.
[[nodiscard]] double substeps_needed(double bound, double dt, double safety, int least);

}  // namespace ember
