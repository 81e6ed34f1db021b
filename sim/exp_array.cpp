#include "sim/exp_array.h"

#include <bit>
#include <cstdint>

#include "sim/vectorise.h"

namespace ember {
namespace {

constexpr double kLn2High = 6.93147180369123816490e-01;  // as in math.cpp
constexpr double kLn2Low = 1.90821492927058770002e-10;
constexpr double kInverseLn2 = 1.44269504088896338700;
// Adding it rounds to a whole number, whose low bits are then those of the sum: a conversion to
// integers that every instruction set has.
constexpr double kRound = 6755399441055744.0;  // 1.5 · 2^52

}  // namespace

EMBER_VECTORISED void exp_array(double* values, std::ptrdiff_t count) {
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const double x = values[i] > 709.0 ? 709.0 : values[i];
        const double safe = x < -708.0 ? -708.0 : x;
        const double shifted = safe * kInverseLn2 + kRound;
        const double k = shifted - kRound;
        const double r = (safe - k * kLn2High) - k * kLn2Low;
        double sum = 1.0 / 6227020800.0;  // Taylor series by Horner, 1/13! to 1/0!
        sum = 1.0 / 479001600.0 + r * sum;
        sum = 1.0 / 39916800.0 + r * sum;
        sum = 1.0 / 3628800.0 + r * sum;
        sum = 1.0 / 362880.0 + r * sum;
        sum = 1.0 / 40320.0 + r * sum;
        sum = 1.0 / 5040.0 + r * sum;
        sum = 1.0 / 720.0 + r * sum;
        sum = 1.0 / 120.0 + r * sum;
        sum = 1.0 / 24.0 + r * sum;
        sum = 1.0 / 6.0 + r * sum;
        sum = 0.5 + r * sum;
        sum = 1.0 + r * sum;
        sum = 1.0 + r * sum;
        // times 2^k: k into the exponent's bits
        const std::uint64_t scaled =
            std::bit_cast<std::uint64_t>(sum) + (std::bit_cast<std::uint64_t>(shifted) << 52);
        values[i] = x < -708.0 ? 0.0 : std::bit_cast<double>(scaled);
    }
}

}  // namespace ember
