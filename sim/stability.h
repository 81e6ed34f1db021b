// How large a sub-step may be: a bound on the fastest motion of the lattice, computed, not guessed.
#pragma once

#include <array>

#include "sim/mechanics.h"

namespace ember {

/// The fastest motions that the sheet as it stands is capable of, linearised.
struct FastestMotion {
    double omega = 0;  ///< [1/s] no undamped mode oscillates faster
    double gamma = 0;  ///< [1/s] no motion is damped faster

    /// Upper bound on the size of every eigenvalue: |λ|² = ω² of a mode that oscillates, and
    /// |λ| <= γ of one that does not.
    [[nodiscard]] double rate() const { return omega > gamma ? omega : gamma; }
};

/// Scratch of find_fastest_motion().
struct StabilityScratch {
    std::vector<double> root;                   ///< [kg^-1/2] 1/√m, N
    std::vector<double> plate;                  ///< what the plate adds to D_i, times √m_i; N
    std::array<std::vector<double>, 7> blocks;  ///< stiffness xx xy xz yy yz zz, damping; N
    /// The same of one row of springs, for each thread.
    std::vector<std::array<std::vector<double>, 7>> row;
    std::vector<FastestMotion> fastest;  ///< of each part
};

/// Bounds ω and γ of the sheet at its present positions. Of a spring with stiffness matrix K
/// between nodes a and b, the energy of any displacement u obeys, in mass-scaled coordinates,
///
///     (u_a/√m_a - u_b/√m_b)ᵀ K (..) <= Σ_{i = a, b} (1/√m_a + 1/√m_b)/√m_i · u_iᵀ K u_i
///
/// (Cauchy-Schwarz), so ω² is at most the largest eigenvalue of the 3×3 blocks
/// D_i = 1/√m_i Σ_springs (1/√m_a + 1/√m_b) K, and γ² likewise with the damping. Inside
/// a uniform sheet that is 5 % above the exact ω, with its lighter border 12 %. K = k nnᵀ +
/// max(k - kl/L, 0)(I - nnᵀ): stretch stiffens across the spring; compression, which makes it
/// buckle, only takes from ω. The bending energies ½ k |Σ c_j u_j|² of a plate add multiples of the
/// identity likewise, add_plate_bound(); `plate` is null without rigidity. Held nodes drop out.
/// Valid for any mass, stretch and topology. `scratch` may be used again; the result does not
/// depend on the number of threads.
[[nodiscard]] FastestMotion find_fastest_motion(const Lattice& lattice, const SheetState& sheet,
                                                const SpringNetwork& network, const Plate* plate,
                                                const NodeLoads& loads, ThreadPool& pool,
                                                StabilityScratch& scratch);

/// What numerics.integrator = auto stands for in a tick of `dt` [s]: velocity_verlet, which needs
/// the fewest right-hand sides per second for the motion of a sheet, unless it would take more
/// than 2000 sub-steps; that happens where a few nodes are very light, which rosenbrock's
/// preconditioner takes care of. For an evenly stiff sheet, a plate included, its conjugate
/// gradients need more products than Verlet needs steps (both grow with the frequency), so it is
/// never the cheaper one: an A4 of office paper on 32×48 takes 150 steps of Verlet a tick, or six
/// to ten times as long by rosenbrock.
[[nodiscard]] IntegratorKind choose_integrator(const NumericsParams& numerics,
                                               const FastestMotion& fastest, double dt);

/// Longest stable sub-step [s] of `integrator` for such motion; +inf for implicit ones.
[[nodiscard]] double stable_step(IntegratorKind integrator, const FastestMotion& fastest);

}  // namespace ember
