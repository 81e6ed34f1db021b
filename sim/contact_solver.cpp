#include "sim/contact_solver.h"

#include <algorithm>
#include <cmath>

namespace ember {
namespace {

constexpr double kSettled = 1e-6;  // [m/s] that a sweep may still change

Vector3 relative_velocity(const Contact& c, const ContactBodies& bodies) {
    Vector3 sum = Vector3::Zero();
    for (std::size_t k = 0; k < c.bodies; ++k)
        sum += c.weight[k] * bodies.velocity[static_cast<std::size_t>(c.body[k])];
    return sum;
}

void push(const Contact& c, const Vector3& impulse, ContactBodies& bodies) {
    for (std::size_t k = 0; k < c.bodies; ++k) {
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

// The velocity to come out with, so that no body has to move faster than that: where nearly all of
// the weight is on bodies that cannot be moved, the others would have to be flung away.
double gently(const Contact& c, const ContactBodies& bodies) {
    if (!(c.least > 0)) return c.least;
    double fastest = 0.0;
    for (std::size_t k = 0; k < c.bodies; ++k) {
        const double given = c.mass * bodies.inverse_mass[static_cast<std::size_t>(c.body[k])];
        fastest = std::max(fastest, std::abs(c.weight[k]) * given);
    }
    return c.least / std::max(1.0, fastest);
}

// Contacts brake, and give no more than what it takes to come out of each other. Sweeps that have
// not settled, where things are caught between others that cannot give way, could give more: then
// all impulses are scaled down together, which leaves every cone of friction and every sum alone.
void stay_passive(std::vector<Contact>& contacts, double allowed, ContactBodies& bodies) {
    double linear = 0.0, square = 0.0;  // [J] work is s · linear + s² · square
    for (std::size_t b = 0; b < bodies.velocity.size(); ++b) {
        const Vector3& impulse = bodies.impulse[b];
        const double half = 0.5 * bodies.inverse_mass[b] * impulse.squaredNorm();
        linear += impulse.dot(bodies.velocity[b]) - 2.0 * half;
        square += half;
    }
    if (!(linear + square > allowed)) return;
    const double scale =
        (std::sqrt(linear * linear + 4.0 * square * allowed) - linear) / (2.0 * square);
    for (std::size_t b = 0; b < bodies.velocity.size(); ++b) {
        bodies.velocity[b] -= (1.0 - scale) * bodies.inverse_mass[b] * bodies.impulse[b];
        bodies.impulse[b] *= scale;
    }
    for (Contact& c : contacts) {
        c.pressed *= scale;
        c.rubbed *= scale;
    }
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
    constexpr double kTogether = 4.0;  // things push each other on, and each has to be moved
    bodies.impulse.assign(bodies.velocity.size(), Vector3::Zero());
    double allowed = 0.0;
    for (Contact& c : contacts) {
        double inverse = 0.0;
        for (std::size_t k = 0; k < c.bodies; ++k) {
            inverse += c.weight[k] * c.weight[k] *
                       bodies.inverse_mass[static_cast<std::size_t>(c.body[k])];
        }
        c.mass = inverse > 0 ? 1.0 / inverse : 0.0;
        c.least = gently(c, bodies);
        const double out = std::max(c.least, 0.0);
        allowed += kTogether * c.mass * out * out;
        c.pressed = 0;
        c.rubbed = Vector3::Zero();
        const double along = c.guess.dot(c.normal);
        if (c.mass == 0 || !(along > 0)) continue;
        c.pressed = along;
        c.rubbed = within(c.guess - along * c.normal, c.friction * along);
        push(c, c.impulse(), bodies);
    }
    int sweeps = 0;
    for (bool settled = false; !settled && sweeps < kMostSweeps; ++sweeps) {
        double largest = 0.0;
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            Contact& c = contacts[sweeps % 2 == 0 ? i : contacts.size() - 1 - i];
            largest = std::max(largest, relax(c, bodies));
        }
        settled = !(largest > kSettled);
    }
    stay_passive(contacts, allowed, bodies);
    return sweeps;
}

}  // namespace ember
