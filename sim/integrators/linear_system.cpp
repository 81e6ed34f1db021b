#include "sim/integrators/linear_system.h"

#include <Eigen/LU>
#include <cmath>

namespace ember {

LinearSystem::LinearSystem(const Mechanics& mechanics) : m_(mechanics) {
    const std::size_t n = m_.node_count();
    mass_.resize(n);
    drag_.assign(n, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
        const double inverse = m_.loads.inverse_mass[i];
        mass_[i] = inverse > 0 ? 1.0 / inverse : 0.0;  // 0: held, and left out of the system
        if (m_.loads.has_drag) drag_[i] = m_.loads.drag[i];
    }
    inverse_block_.resize(n);
    for (auto* array : {&right_, &residual_, &z_, &direction_, &product_})
        array->resize(3 * n);
}

void LinearSystem::assemble(const double* x, double s) {
    s_ = s;
    const std::size_t n = m_.node_count();
    links_.clear();
    for (std::size_t i = 0; i < n; ++i)
        inverse_block_[i] = (mass_[i] + s * drag_[i]) * Eigen::Matrix3d::Identity();
    for_each_spring(m_.lattice, m_.network, [&](Index a, Index b, Index slot, double k, double d) {
        const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
        const Vector3 edge(x[j] - x[i], x[n + j] - x[n + i], x[2 * n + j] - x[2 * n + i]);
        const double length = edge.norm();
        if (!(length > 0)) return;
        const Vector3 e = edge / length;
        const double rest = m_.sheet.rest_length[static_cast<std::size_t>(slot)];
        const double across = std::max(0.0, k * (1.0 - rest / length));
        links_.push_back({a, b, {e.x(), e.y(), e.z()}, k, across, d});
        const Eigen::Matrix3d block = (s * d + s * s * (k - across)) * e * e.transpose() +
                                      s * s * across * Eigen::Matrix3d::Identity();
        inverse_block_[i] += block;
        inverse_block_[j] += block;
    });
    if (m_.plate != nullptr) {
        plate_.assign(n, 0.0);
        add_plate_diagonal(m_.lattice, *m_.plate, plate_);
        for (std::size_t i = 0; i < n; ++i)
            inverse_block_[i] += s * s * plate_[i] * Eigen::Matrix3d::Identity();
    }
    for (std::size_t i = 0; i < n; ++i) {
        inverse_block_[i] = mass_[i] > 0 ? Eigen::Matrix3d(inverse_block_[i].inverse())
                                         : Eigen::Matrix3d(Eigen::Matrix3d::Zero());
    }
}

// product = (mass + s_damping D + s_stiffness K) p; rows of held nodes are 0.
void LinearSystem::apply(const double* p, double* product, double s_damping, double s_stiffness,
                         bool with_mass) const {
    const std::size_t n = m_.node_count();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i < n; ++i) {
            const double own = (with_mass ? mass_[i] : 0.0) + s_damping * drag_[i];
            product[axis * n + i] = own * p[axis * n + i];
        }
    }
    for (const Link& link : links_) {
        const auto i = static_cast<std::size_t>(link.a), j = static_cast<std::size_t>(link.b);
        double d[3], along = 0.0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            d[axis] = p[axis * n + i] - p[axis * n + j];
            along += d[axis] * link.n[axis];
        }
        const double across = s_stiffness * link.across;
        const double extra =
            (s_damping * link.damping + s_stiffness * (link.along - link.across)) * along;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double f = across * d[axis] + extra * link.n[axis];
            product[axis * n + i] += f;
            product[axis * n + j] -= f;
        }
    }
    if (m_.plate != nullptr) {
        m_.plate_forces->evaluate_linear(m_.lattice, *m_.plate, p, n, m_.pool);
        for (std::size_t i = 0; i < 3 * n; ++i)
            product[i] -= s_stiffness * m_.plate_forces->total[i];
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i < n; ++i) {
            if (mass_[i] == 0.0) product[axis * n + i] = 0.0;
        }
    }
}

void LinearSystem::precondition(const double* r, double* z) const {
    const std::size_t n = m_.node_count();
    for (std::size_t i = 0; i < n; ++i) {
        const Vector3 out = inverse_block_[i] * Vector3(r[i], r[n + i], r[2 * n + i]);
        z[i] = out.x();
        z[n + i] = out.y();
        z[2 * n + i] = out.z();
    }
}

double LinearSystem::dot(const std::vector<double>& p, const std::vector<double>& q) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i)
        sum += p[i] * q[i];
    return sum;
}

void LinearSystem::right_side(const double* r_x, const double* r_v, double s) {
    const std::size_t n = m_.node_count();
    apply(r_x, right_.data(), 0.0, s, false);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i < n; ++i) {
            double& r = right_[axis * n + i];
            r = mass_[i] * r_v[axis * n + i] - r;
        }
    }
}

int LinearSystem::solve(double* k) {
    constexpr int kMostIterations = 2000;
    constexpr double kTolerance = 1e-8;
    const std::size_t size = right_.size();
    apply(k, product_.data(), s_, s_ * s_, true);
    for (std::size_t i = 0; i < size; ++i)
        residual_[i] = right_[i] - product_[i];
    precondition(right_.data(), z_.data());
    const double limit = kTolerance * kTolerance * dot(right_, z_);
    precondition(residual_.data(), z_.data());
    direction_ = z_;
    double rz = dot(residual_, z_);
    for (int iteration = 0; iteration < kMostIterations; ++iteration) {
        if (rz <= limit) return iteration;
        if (!std::isfinite(rz)) return -iteration - 1;
        apply(direction_.data(), product_.data(), s_, s_ * s_, true);
        const double alpha = rz / dot(direction_, product_);
        for (std::size_t i = 0; i < size; ++i) {
            k[i] += alpha * direction_[i];
            residual_[i] -= alpha * product_[i];
        }
        precondition(residual_.data(), z_.data());
        const double next = dot(residual_, z_);
        const double beta = next / rz;
        rz = next;
        for (std::size_t i = 0; i < size; ++i)
            direction_[i] = z_[i] + beta * direction_[i];
    }
    return -kMostIterations;
}

}  // namespace ember
