// Positions and velocities as the integrators hold them, and linear combinations of such arrays.
#pragma once

#include <initializer_list>
#include <span>
#include <vector>

#include "sim/mechanics.h"

namespace ember {

/// x [m] and v [m/s], 3N each with kMotionPadding zeros behind: all x components, all y, all z.
struct Motion {
    std::vector<double> x, v;

    void resize(std::size_t node_count);
    void read(const SheetState& sheet);
    void write(SheetState& sheet) const;
};

/// One term of a linear combination.
struct Term {
    double factor;
    const double* values;
};

/// out = base + Σ factor · values, elements [0, count); terms are added in their order, those with
/// factor 0 are left out. out may be base. Same bits for any number of threads.
void combine(double* out, const double* base, std::span<const Term> terms, std::size_t count,
             ThreadPool& pool);
inline void combine(double* out, const double* base, std::initializer_list<Term> terms,
                    std::size_t count, ThreadPool& pool) {
    combine(out, base, std::span(terms.begin(), terms.size()), count, pool);
}

/// √(Σ values² / nodes): root mean square length of `count` / 3 vectors.
[[nodiscard]] double root_mean_square(const double* values, std::size_t count);

}  // namespace ember
