// The linear system of a linearly implicit step, (M + s D + s² K) k = M r_v - s K r_x, solved
// without a matrix by conjugate gradients with a block Jacobi preconditioner.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/mechanics.h"

namespace ember {

class LinearSystem {
  public:
    explicit LinearSystem(const Mechanics& mechanics);

    /// Linearises at positions x [m], 3N, with s = γh [s]. Springs that are compressed would make K
    /// indefinite by their stiffness across, which is left out; the drag of the air enters as if it
    /// were the same in all directions. Neither changes the order of the method.
    void assemble(const double* x, double s);
    /// Sets the right side from r_x [m/s] and r_v [m/s²], 3N, for the assembled s.
    void right_side(const double* r_x, const double* r_v, double s);
    /// Solves for k [m/s²], 3N, from the guess in it, to a relative residual of 1e-8 in the
    /// energy norm of the preconditioner. Returns the iterations, negative when it did not
    /// converge.
    [[nodiscard]] int solve(double* k);

  private:
    struct Link {
        Index a, b;
        double n[3];
        double along, across, damping;  // [N/m], [N/m], [kg/s]
    };
    void apply(const double* p, double* product, double s_damping, double s_stiffness,
               bool with_mass) const;
    void precondition(const double* r, double* z) const;
    [[nodiscard]] double dot(const std::vector<double>& p, const std::vector<double>& q) const;

    const Mechanics& m_;
    double s_ = 0;
    std::vector<Link> links_;
    std::vector<double> mass_, drag_, plate_;
    std::vector<Eigen::Matrix3d> inverse_block_;
    std::vector<double> right_, residual_, z_, direction_, product_;
};

}  // namespace ember
