// Compiled with -O3 -march=native and with fused multiply-add.
#include <algorithm>
#include <cmath>

#include "problem.h"

namespace ember::peers {
namespace {

constexpr std::ptrdiff_t kBorder = 2;  // how far a spring reaches

// `count` springs from nodes a to nodes b of one row; n is the number of all nodes.
void row_of_springs(std::ptrdiff_t count, std::ptrdiff_t n, const double* __restrict xa,
                    const double* __restrict xb, const double* __restrict va,
                    const double* __restrict vb, const double* __restrict stiffness,
                    const double* __restrict damping, const double* __restrict rest,
                    double* __restrict fx, double* __restrict fy, double* __restrict fz) {
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const double dx = xb[i] - xa[i], dy = xb[i + n] - xa[i + n],
                     dz = xb[i + 2 * n] - xa[i + 2 * n];
        const double u = vb[i] - va[i], v = vb[i + n] - va[i + n],
                     w = vb[i + 2 * n] - va[i + 2 * n];
        const double inverse = 1.0 / std::sqrt(dx * dx + dy * dy + dz * dz);
        const double rate = (u * dx + v * dy + w * dz) * inverse;
        const double scale = stiffness[i] + (damping[i] * rate - stiffness[i] * rest[i]) * inverse;
        fx[i] = scale * dx;
        fy[i] = scale * dy;
        fz[i] = scale * dz;
    }
}

// Forces of six kinds on the nodes of a row: f[k] at their own springs, g[k] at those that end
// there.
void gather(std::ptrdiff_t count, const double* const* f, const double* const* g,
            const double* __restrict load, const double* __restrict inverse_mass,
            double* __restrict a) {
    const double *f0 = f[0], *f1 = f[1], *f2 = f[2], *f3 = f[3], *f4 = f[4], *f5 = f[5];
    const double *g0 = g[0], *g1 = g[1], *g2 = g[2], *g3 = g[3], *g4 = g[4], *g5 = g[5];
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const double sum = f0[i] - g0[i] + f1[i] - g1[i] + f2[i] - g2[i] + f3[i] - g3[i] + f4[i] -
                           g4[i] + f5[i] - g5[i];
        a[i] = (sum + load[i]) * inverse_mass[i];
    }
}

class Plain final : public RightHandSide {
  public:
    explicit Plain(const PlainProblem& problem) : stencil_(problem), n_(problem.load_y.size()) {}

  private:
    void evaluate(const double* y, double* dydt) override {
        std::copy_n(y + 3 * n_, 3 * n_, dydt);
        stencil_.accelerate(y, y + 3 * n_, dydt + 3 * n_);
    }

    PlainStencil stencil_;
    std::size_t n_;
};

}  // namespace

PlainStencil::PlainStencil(const PlainProblem& problem)
    : p_(problem), pitch_((problem.columns + 2 * kBorder + 7) / 8 * 8) {
    const std::ptrdiff_t rows = p_.rows + 2 * kBorder;
    force_.assign(p_.springs.size(),
                  std::vector<double>(static_cast<std::size_t>(3 * rows * pitch_), 0.0));
}

void PlainStencil::accelerate(const double* x, const double* v, double* a) {
    const std::ptrdiff_t n = std::ptrdiff_t{p_.rows} * p_.columns;
    const std::ptrdiff_t plane = (p_.rows + 2 * kBorder) * pitch_;
    const auto padded = [&](std::ptrdiff_t r) { return (r + kBorder) * pitch_ + kBorder; };
    for (std::size_t k = 0; k < p_.springs.size(); ++k) {
        const SpringField& s = p_.springs[k];
        const std::ptrdiff_t first = std::max(0, -s.columns_ahead);
        const std::ptrdiff_t count = p_.columns - std::abs(s.columns_ahead);
        for (std::ptrdiff_t r = 0; r + s.rows_ahead < p_.rows; ++r) {
            const std::ptrdiff_t i = r * p_.columns + first;
            const std::ptrdiff_t j = i + s.rows_ahead * p_.columns + s.columns_ahead;
            double* f = force_[k].data() + padded(r) + first;
            row_of_springs(count, n, x + i, x + j, v + i, v + j, s.stiffness.data() + i,
                           s.damping.data() + i, s.rest.data() + i, f, f + plane, f + 2 * plane);
        }
    }
    const std::vector<double> none(static_cast<std::size_t>(p_.columns), 0.0);
    for (std::ptrdiff_t axis = 0; axis < 3; ++axis) {
        for (std::ptrdiff_t r = 0; r < p_.rows; ++r) {
            const double *own[6], *other[6];
            for (std::size_t k = 0; k < 6; ++k) {
                const SpringField& s = p_.springs[k];
                own[k] = force_[k].data() + axis * plane + padded(r);
                other[k] = own[k] - s.rows_ahead * pitch_ - s.columns_ahead;
            }
            const std::ptrdiff_t i = r * p_.columns;
            gather(p_.columns, own, other, axis == 1 ? p_.load_y.data() + i : none.data(),
                   p_.inverse_mass.data() + i, a + axis * n + i);
        }
    }
}

std::unique_ptr<RightHandSide> plain_right_hand_side(const PlainProblem& problem) {
    return std::make_unique<Plain>(problem);
}

}  // namespace ember::peers
