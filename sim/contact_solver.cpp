#include "sim/contact_solver.h"

#include <algorithm>
#include <cmath>

namespace ember {
namespace {

constexpr double kSettled = 1e-6;  // [m/s] that a sweep may still change

Vector3 relative_velocity(const Contact& c, const ContactBodies& bodies) {
    Vector3 sum = Vector3::Zero();
    for (std::size_t k = 0; k < 4; ++k)
        sum += c.weight[k] * bodies.velocity[static_cast<std::size_t>(c.body[k])];
    return sum;
}

void push(const Contact& c, const Vector3& impulse, ContactBodies& bodies) {
    for (std::size_t k = 0; k < 4; ++k) {
        const auto b = static_cast<std::size_t>(c.body[k]);
        const Vector3 part = c.weight[k] * impulse;
        bodies.impulse[b] += part;
        bodies.velocity[b] += bodies.inverse_mass[b] * part;
    }
}

// The vector, or as much of it as is no longer than `limit`.
Vector3 within(const Vector3& vector, double limit) {
    const double length = vector.norm();
    return length > limit ? Vector3(limit / length * vector) : vector;
}

// Returns by how much the relative velocity has changed [m/s].
double relax(Contact& c, ContactBodies& bodies) {
    if (c.mass == 0) return 0.0;
    const Vector3 u = relative_velocity(c, bodies);
    const double along = u.dot(c.normal);
    const double pressed = std::max(0.0, c.pressed + c.mass * (c.least - along));
    const Vector3 rubbed = within(c.rubbed - c.mass * (u - along * c.normal), c.friction * pressed);
    const Vector3 change = (pressed - c.pressed) * c.normal + (rubbed - c.rubbed);
    c.pressed = pressed;
    c.rubbed = rubbed;
    push(c, change, bodies);
    return change.norm() / c.mass;
}

}  // namespace

double least_speed(double gap, double speed, double interval, double soft) {
    constexpr double kRecovery = 30.0;      // [1/s]
    constexpr double kFastestSoftly = 0.1;  // [m/s]
    constexpr double kFastest = 1.0;        // [m/s]
    if (gap >= 0) return std::min(0.0, -(gap / interval + 0.5 * speed) / 1.5);
    return std::max(std::min(-gap * kRecovery, kFastestSoftly),
                    std::min(-(gap + soft) / interval, kFastest));
}

int solve_contacts(std::vector<Contact>& contacts, ContactBodies& bodies) {
    bodies.impulse.assign(bodies.velocity.size(), Vector3::Zero());
    for (Contact& c : contacts) {
        double inverse = 0.0;
        for (std::size_t k = 0; k < 4; ++k) {
            inverse += c.weight[k] * c.weight[k] *
                       bodies.inverse_mass[static_cast<std::size_t>(c.body[k])];
        }
        c.mass = inverse > 0 ? 1.0 / inverse : 0.0;
        c.pressed = 0;
        c.rubbed = Vector3::Zero();
        const double along = c.guess.dot(c.normal);
        if (c.mass == 0 || !(along > 0)) continue;
        c.pressed = along;
        c.rubbed = within(c.guess - along * c.normal, c.friction * along);
        push(c, c.impulse(), bodies);
    }
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
        double largest = 0.0;
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            Contact& c = contacts[sweep % 2 == 0 ? i : contacts.size() - 1 - i];
            largest = std::max(largest, relax(c, bodies));
        }
        if (!(largest > kSettled)) return sweep + 1;
    }
    return kMostSweeps;
}

}  // namespace ember
