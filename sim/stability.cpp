#include "sim/stability.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace ember {
namespace {

using Block = Eigen::Matrix3d;

// Upper bound on the largest eigenvalue of a symmetric positive semi-definite 3×3 matrix: the
// smaller of the row-sum norm and q + 2p of the trigonometric solution (with its cosine as 1).
double largest_eigenvalue_bound(const Block& m) {
    const double row_sum = m.cwiseAbs().rowwise().sum().maxCoeff();
    const double q = m.trace() / 3.0;
    const Block shifted = m - q * Block::Identity();
    const double p = std::sqrt(shifted.squaredNorm() / 6.0);
    return std::min(row_sum, q + 2.0 * p);
}

// Row sums of one mass-scaled block matrix: diagonal blocks, and the norms beside them.
struct RowSums {
    std::vector<Block> diagonal;
    std::vector<double> beside;

    explicit RowSums(std::size_t n) : diagonal(n, Block::Zero()), beside(n, 0.0) {}

    void add(std::size_t a, std::size_t b, double inverse_a, double inverse_b, const Block& block,
             double norm) {
        diagonal[a] += inverse_a * block;
        diagonal[b] += inverse_b * block;
        const double off = norm * std::sqrt(inverse_a * inverse_b);
        beside[a] += off;
        beside[b] += off;
    }
    [[nodiscard]] double largest() const {
        double largest = 0.0;
        for (std::size_t n = 0; n < beside.size(); ++n) {
            largest = std::max(largest, largest_eigenvalue_bound(diagonal[n]) + beside[n]);
        }
        return largest;
    }
};

}  // namespace

double spectral_bound(const Lattice& lattice, const SheetState& sheet, const SpringNetwork& network,
                      const NodeLoads& loads) {
    const std::size_t nodes = sheet.mass.size();
    RowSums stiffness(nodes), damping(nodes);
    for_each_spring(lattice, network, [&](Index ia, Index ib, Index slot, double k, double d) {
        const auto a = static_cast<std::size_t>(ia), b = static_cast<std::size_t>(ib);
        const Vector3 along = sheet.position.at(b) - sheet.position.at(a);
        const double length = along.norm();
        if (!(length > 0)) return;
        const Vector3 n = along / length;
        const double rest = sheet.rest_length[static_cast<std::size_t>(slot)];
        const double transverse = k * std::abs(1.0 - rest / length);
        const Block axis = n * n.transpose();
        const double inverse_a = loads.inverse_mass[a], inverse_b = loads.inverse_mass[b];
        stiffness.add(a, b, inverse_a, inverse_b,
                      (k - transverse) * axis + transverse * Block::Identity(),
                      std::max(k, transverse));
        damping.add(a, b, inverse_a, inverse_b, d * axis, d);
    });
    double drag = 0.0;
    if (loads.has_drag) {
        for (std::size_t n = 0; n < nodes; ++n) {
            drag = std::max(drag, loads.drag[n] * loads.inverse_mass[n]);
        }
    }
    const double omega_squared = stiffness.largest();
    const double gamma = damping.largest() + drag;
    return 0.5 * (gamma + std::sqrt(gamma * gamma + 4.0 * omega_squared));
}

double substeps_needed(double bound, double dt, double safety, int least) {
    return std::max(static_cast<double>(least),
                    std::ceil(bound * dt / (safety * kRungeKuttaLimit)));
}

}  // namespace ember
