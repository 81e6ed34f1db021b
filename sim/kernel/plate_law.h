// The law of one element of a plate (plate.h), to be inlined into loops over many.
#pragma once

#include <cmath>

#include "sim/lattice.h"
#include "sim/world_state.h"

#define EMBER_INLINE __attribute__((always_inline)) inline

namespace ember::plate {

// Three numbers that the loops below keep in registers.
struct Triple {
    double x, y, z;
};
EMBER_INLINE Triple operator+(const Triple& a, const Triple& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
EMBER_INLINE Triple operator-(const Triple& a, const Triple& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
EMBER_INLINE Triple operator*(double s, const Triple& a) {
    return {s * a.x, s * a.y, s * a.z};
}
EMBER_INLINE double dot(const Triple& a, const Triple& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
EMBER_INLINE Triple cross(const Triple& a, const Triple& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Unit normal u × w / |u × w| and 1 / |u × w|; 0 where the sheet has no area.
struct Normal {
    Triple n;
    double inverse;
};
EMBER_INLINE Normal normal_of(const Triple& u, const Triple& w) {
    const Triple area = cross(u, w);
    const double square = dot(area, area);
    const double inverse = square > 0.0 ? 1.0 / std::sqrt(square + 1e-300) : 0.0;
    return {inverse * area, inverse};
}

// Derivatives of the energy by u and w, on which the normal depends, when it is g by -n.
struct Turn {
    Triple u, w;
};
EMBER_INLINE Turn turn_of(const Normal& normal, const Triple& u, const Triple& w, const Triple& g) {
    const Triple h = normal.inverse * (g - dot(g, normal.n) * normal.n);
    return {cross(w, h), cross(h, u)};
}

// Curvatures at rest, as second differences [m].
struct Bent {
    double main, cross, twist;
};

inline Bent bent_at(const Lattice& lattice, const RestCurvature& rest, Index site) {
    if (rest.main.empty()) return {0.0, 0.0, 0.0};
    const auto s = static_cast<std::size_t>(site);
    const double dx = lattice.column_spacing, dz = lattice.row_spacing;
    return {dx * dx * rest.main[s], dz * dz * rest.cross[s], dx * dz * rest.twist[s]};
}

EMBER_INLINE Triple second(const Triple& a, const Triple& b, const Triple& c) {
    return a - 2.0 * b + c;
}

// What one element does to its nodes.
struct Moments {
    Triple main, cross;
    Turn turn;
    double energy;
};
struct Stiffness {
    double main, coupling, cross;
};
struct Around {
    Triple centre, west, east, north, south;
};

EMBER_INLINE Moments moments_of(const Stiffness& k, const Around& x, const Bent& bent) {
    const Triple u = x.east - x.west, w = x.south - x.north;
    const Normal normal = normal_of(u, w);
    const Triple main = second(x.west, x.centre, x.east) - bent.main * normal.n;
    const Triple across = second(x.north, x.centre, x.south) - bent.cross * normal.n;
    Moments m;
    m.main = k.main * main + k.coupling * across;
    m.cross = k.coupling * main + k.cross * across;
    m.turn = turn_of(normal, u, w, bent.main * m.main + bent.cross * m.cross);
    m.energy = 0.5 * (dot(m.main, main) + dot(m.cross, across));
    return m;
}

struct Twist {
    Triple moment;
    Turn turn;
    double energy;
};

// Corners in the order of a Quad.
EMBER_INLINE Twist twist_of(double k, const Triple& a, const Triple& b, const Triple& c,
                            const Triple& d, double bent) {
    const Triple down = c - a, up = d - b;
    const Normal normal = normal_of(down, up);
    const Triple twist = a - b + c - d - bent * normal.n;
    Twist t;
    t.moment = k * twist;
    t.turn = turn_of(normal, down, up, bent * t.moment);
    t.energy = 0.5 * dot(t.moment, twist);
    return t;
}

}  // namespace ember::plate
