// Impulses that keep things in contact apart, with Coulomb friction.
//
// Each contact asks for a relative normal velocity u at the end of an interval of h [s], given that
// forces are constant during it, so that the gap g closes by h (u0 + u)/2:
//
//     g >= 0:  u >= min(0, -(g/h + u0/2) / 1.5)   leaves a gap from which the next interval can
//                                                 brake as gently: the approach dies out, and
//                                                 nothing bounces
//     g < 0:   u >= min(-g · 30/s, 0.1 m/s)       comes out slowly, so that nothing pops up,
//              but what is deeper than a soft depth s, pressed in by springs say, at once:
//              u >= min(-(g + s)/h, 1 m/s)
//
// Impulses are found by projected Gauss-Seidel sweeps, forwards and backwards: normal ones never
// pull, tangential ones stop the sliding as far as μ times the normal one can (Moreau 1988;
// Jean 1999). The impulses of a contact on its nodes add up to zero.
#pragma once

#include <array>
#include <vector>

#include "sim/types.h"

namespace ember {

/// Nodes that contacts act on, whatever sheet they belong to; all arrays B.
struct ContactBodies {
    std::vector<double> inverse_mass;  ///< [1/kg] 0: cannot be moved
    std::vector<Vector3> velocity;     ///< [m/s] at the end of the interval, so far
    std::vector<Vector3> impulse;      ///< [kg m/s] given by contacts
};

/// One body on the ground, or four whose weights add up to 0.
struct Contact {
    std::size_t bodies = 4;  ///< as many of the following count
    std::array<Index, 4> body{};
    std::array<double, 4> weight{};
    Vector3 normal;       ///< [1] along which the relative velocity Σ weight · v must not be less
    double least = 0;     ///< [m/s] than this
    double friction = 0;  ///< [1]
    double mass = 0;      ///< [kg] 1 / Σ weight²/m; 0: cannot be moved
    Vector3 guess = Vector3::Zero();   ///< [kg m/s] impulse to begin with
    double pressed = 0;                ///< [kg m/s] normal impulse so far
    Vector3 rubbed = Vector3::Zero();  ///< [kg m/s] tangential one
    Index source = kNone;              ///< what it comes from, for whoever made it

    [[nodiscard]] Vector3 impulse() const { return pressed * normal + rubbed; }
};

/// The velocity to ask for after `interval` [s], for a gap [m] that changes by `speed` [m/s] now,
/// with the depth `soft` [m].
[[nodiscard]] double least_speed(double gap, double speed, double interval, double soft);

/// Sweeps until impulses settle, at most kMostSweeps times; the order of contacts is that of the
/// list. Impulses begin with what Contact::guess has of them that pushes and rubs no more than it
/// may. Contact::mass, pressed and rubbed, and ContactBodies::impulse need not be set.
/// Returns the number of sweeps.
inline constexpr int kMostSweeps = 30;
int solve_contacts(std::vector<Contact>& contacts, ContactBodies& bodies);

}  // namespace ember
