// The linear system of a linearly implicit step, (M + s D + s² K) k = M r_v - s K r_x, solved
// without a matrix by conjugate gradients with a block Jacobi preconditioner.
//
// Whole springs are a stencil over the lattice, a row at a time; each node gathers its twelve in a
// fixed order, and scalar products are sums over rows, so that the result does not depend on the
// number of threads. Everything is kept from tick to tick.
#pragma once

#include <array>
#include <vector>

#include "sim/mechanics.h"

namespace ember {

class LinearSystem {
  public:
    /// Takes the masses of a tick. Allocates only what nodes and springs have been added.
    void begin(const Mechanics& mechanics);
    /// Linearises at positions x [m], 3N, with s = γh [s]. Springs that are compressed would make K
    /// indefinite by their stiffness across, which is left out, as is the turning of the normal of
    /// a plate with rest curvature; the drag of the air enters as if it were the same in all
    /// directions. None of it changes the order of the method.
    void assemble(const Mechanics& mechanics, const double* x, double s);
    /// Sets the right side from r_x [m/s] and r_v [m/s²], 3N, for the assembled s.
    void right_side(const Mechanics& mechanics, const double* r_x, const double* r_v);
    /// Solves for k [m/s²], 3N, from the guess in it, to a relative residual of 1e-8 in the norm of
    /// the preconditioner, or until the mean error of k, weighted by mass, is certainly below
    /// `error` [m/s²]: since the system is no smaller than M, |δk|_M <= |r|_M⁻¹. Returns the
    /// iterations, negative when it did not converge.
    [[nodiscard]] int solve(const Mechanics& mechanics, double error, double* k);

  private:
    // mass M + damping D + stiffness K
    struct Factors {
        double mass, damping, stiffness;
    };
    struct Norms {
        double preconditioned, by_mass;  // r·P⁻¹r and r·M⁻¹r
    };
    // An extra spring, linearised.
    struct Link {
        Vector3 axis;
        double along, across;  // [N/m]
    };

    void apply(const Mechanics& mechanics, const double* p, const Factors& factors);
    void add_extra(const Mechanics& mechanics, const double* p, const Factors& factors);
    void sum_blocks(const Mechanics& mechanics, double s);
    Norms precondition(const Mechanics& mechanics, const std::vector<double>& residual);
    double advance(const Mechanics& mechanics, double* k, double rz);

    double s_ = 0, total_mass_ = 0;
    std::vector<double> mass_, inverse_mass_, drag_;  // [kg], [1/kg], [kg/s]; N; 0 if held
    std::array<std::vector<double>, 3> axis_;         // unit vector along each slot, 6×S
    std::vector<double> along_, across_;              // [N/m] 6×S
    std::vector<Link> extra_;                         // X
    std::array<std::vector<double>, 6> block_;        // xx xy xz yy yz zz of P, then of P⁻¹; N
    std::vector<double> plate_;                       // [N/m] diagonal of the plate, N
    std::vector<double> right_, residual_, z_, direction_, product_;  // 3N
    std::vector<double> sums_, mass_sums_;                            // of groups of nodes
};

}  // namespace ember
