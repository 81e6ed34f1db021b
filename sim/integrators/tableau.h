// Coefficients of explicit Runge-Kutta methods.
//
// The equations are of second order, x' = v and v' = a(x, v), so the stage velocities can be
// eliminated (Nyström's form): with the sums A·A and b·A of a method's coefficients, only
// accelerations need to be kept,
//
//     x_i = x + c_i h v + h² Σ_j (A·A)_ij a_j        v_i = v + h Σ_j A_ij a_j
//     x'  = x +     h v + h² Σ_j (b·A)_j a_j         v'  = v + h Σ_j b_j a_j
//
// which is the same method to rounding.
#pragma once

#include <array>
#include <cstddef>

namespace ember {

inline constexpr std::size_t kMostStages = 13;
using StageRow = std::array<double, kMostStages>;

/// A method with its Nyström sums. Rows and columns beyond `stages` are 0.
struct Tableau {
    std::size_t stages = 0;
    int error_order = 0;  ///< the error estimate shrinks as h^error_order; 0: there is none
    bool first_same_as_last = false;        ///< the last stage is the first of the next step
    std::array<StageRow, kMostStages> a{};  ///< Butcher's A
    StageRow b{}, error{};                  ///< weights; difference to those of the other order
    std::array<StageRow, kMostStages> aa{};
    StageRow c{}, ba{}, error_a{};
};

/// Row times matrix, for the Nyström sums.
constexpr StageRow times(const StageRow& row, const std::array<StageRow, kMostStages>& a) {
    StageRow product{};
    for (std::size_t k = 0; k < kMostStages; ++k) {
        for (std::size_t j = 0; j < kMostStages; ++j)
            product[j] += row[k] * a[k][j];
    }
    return product;
}

/// Fills in what follows from A, b and error.
constexpr Tableau complete(Tableau t) {
    for (std::size_t i = 0; i < t.stages; ++i) {
        for (const double a : t.a[i])
            t.c[i] += a;
        t.aa[i] = times(t.a[i], t.a);
    }
    t.ba = times(t.b, t.a);
    t.error_a = times(t.error, t.a);
    return t;
}

/// The classical method of order 4 (Kutta 1901), the paper's.
inline constexpr Tableau kRk4 = complete({.stages = 4,
                                          .a = {{{}, {1.0 / 2}, {0, 1.0 / 2}, {0, 0, 1}}},
                                          .b = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}});

/// Order 5 with an estimate of order 4 (Dormand and Prince 1980).
inline constexpr Tableau kDopri5 =
    complete({.stages = 7,
              .error_order = 5,
              .first_same_as_last = true,
              .a = {{{},
                     {1.0 / 5},
                     {3.0 / 40, 9.0 / 40},
                     {44.0 / 45, -56.0 / 15, 32.0 / 9},
                     {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
                     {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
                     {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}}},
              .b = {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84},
              .error = {71.0 / 57600, 0, -71.0 / 16695, 71.0 / 1920, -17253.0 / 339200, 22.0 / 525,
                        -1.0 / 40}});

/// Order 6 in the fewest stages that there can be (Butcher 1964).
inline constexpr Tableau kButcher6 =
    complete({.stages = 7,
              .a = {{{},
                     {1.0 / 3},
                     {0, 2.0 / 3},
                     {1.0 / 12, 1.0 / 3, -1.0 / 12},
                     {-1.0 / 16, 9.0 / 8, -3.0 / 16, -3.0 / 8},
                     {0, 9.0 / 8, -3.0 / 8, -3.0 / 4, 1.0 / 2},
                     {9.0 / 44, -9.0 / 11, 63.0 / 44, 18.0 / 11, 0, -16.0 / 11}}},
              .b = {11.0 / 120, 0, 27.0 / 40, 27.0 / 40, -4.0 / 15, -4.0 / 15, 11.0 / 120}});

/// Order 8 with an estimate of order 7 (Fehlberg 1968).
inline constexpr Tableau kRkf78 = complete(
    {.stages = 13,
     .error_order = 8,
     .a = {{{},
            {2.0 / 27},
            {1.0 / 36, 1.0 / 12},
            {1.0 / 24, 0, 1.0 / 8},
            {5.0 / 12, 0, -25.0 / 16, 25.0 / 16},
            {1.0 / 20, 0, 0, 1.0 / 4, 1.0 / 5},
            {-25.0 / 108, 0, 0, 125.0 / 108, -65.0 / 27, 125.0 / 54},
            {31.0 / 300, 0, 0, 0, 61.0 / 225, -2.0 / 9, 13.0 / 900},
            {2, 0, 0, -53.0 / 6, 704.0 / 45, -107.0 / 9, 67.0 / 90, 3},
            {-91.0 / 108, 0, 0, 23.0 / 108, -976.0 / 135, 311.0 / 54, -19.0 / 60, 17.0 / 6,
             -1.0 / 12},
            {2383.0 / 4100, 0, 0, -341.0 / 164, 4496.0 / 1025, -301.0 / 82, 2133.0 / 4100,
             45.0 / 82, 45.0 / 164, 18.0 / 41},
            {3.0 / 205, 0, 0, 0, 0, -6.0 / 41, -3.0 / 205, -3.0 / 41, 3.0 / 41, 6.0 / 41},
            {-1777.0 / 4100, 0, 0, -341.0 / 164, 4496.0 / 1025, -289.0 / 82, 2193.0 / 4100,
             51.0 / 82, 33.0 / 164, 12.0 / 41, 0, 1}}},
     .b = {0, 0, 0, 0, 0, 34.0 / 105, 9.0 / 35, 9.0 / 35, 9.0 / 280, 9.0 / 280, 0, 41.0 / 840,
           41.0 / 840},
     .error = {-41.0 / 840, 0, 0, 0, 0, 0, 0, 0, 0, 0, -41.0 / 840, 41.0 / 840, 41.0 / 840}});

}  // namespace ember
