#include "sim/math.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace ember {
namespace {

constexpr double kLn2High = 6.93147180369123816490e-01;  // the sum of the two is ln 2; the high
constexpr double kLn2Low = 1.90821492927058770002e-10;   // part times any exponent is exact
constexpr double kInverseLn2 = 1.44269504088896338700;

// 2^k for k in the normal range
double power_of_two(std::int64_t k) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(k + 1023) << 52);
}

}  // namespace

double exp(double x) {
    if (!(x < 709.782712893384)) {
        return x != x ? x : std::numeric_limits<double>::infinity();
    }
    if (x < -745.2) return 0.0;
    // x = k ln 2 + r with |r| <= ln 2 / 2
    const double k_real = std::floor(x * kInverseLn2 + 0.5);
    const double r = (x - k_real * kLn2High) - k_real * kLn2Low;
    // Taylor series by Horner; the first term left out is r^14/14! < 1e-17
    double sum = 1.0;
    for (int n = 13; n >= 1; --n)
        sum = 1.0 + r / n * sum;
    const auto k = static_cast<std::int64_t>(k_real);
    // in two steps, so that results close to the smallest and largest numbers survive
    const std::int64_t half = k / 2;
    return sum * power_of_two(half) * power_of_two(k - half);
}

double log(double x) {
    if (!(x > 0)) return std::numeric_limits<double>::quiet_NaN();
    if (x > std::numeric_limits<double>::max()) return x;
    std::int64_t exponent = 0;
    if (x < std::numeric_limits<double>::min()) {  // subnormal: make it normal first
        x *= power_of_two(54);
        exponent = -54;
    }
    const auto bits = std::bit_cast<std::uint64_t>(x);
    exponent += static_cast<std::int64_t>(bits >> 52) - 1023;
    double m = std::bit_cast<double>((bits & 0xFFFFFFFFFFFFFull) | 0x3FF0000000000000ull);
    if (m > 1.4142135623730951) {
        m *= 0.5;
        ++exponent;
    }
    // log m = 2 artanh(f), |f| <= 0.172; the first term left out is below 1e-18
    const double f = (m - 1.0) / (m + 1.0);
    const double f2 = f * f;
    double sum = 0.0;
    for (int n = 21; n >= 1; n -= 2)
        sum = 1.0 / n + f2 * sum;
    const auto e = static_cast<double>(exponent);
    return e * kLn2High + (2.0 * f * sum + e * kLn2Low);
}

double sin(double x) {
    // x = k π/2 + r, |r| <= π/4; then sin or cos of r by Taylor series
    constexpr double kHalfPiHigh = 1.5707963267341256, kHalfPiLow = 6.0771005063039660e-11;
    const double k = std::floor(x * 0.6366197723675814 + 0.5);
    const double r = (x - k * kHalfPiHigh) - k * kHalfPiLow;
    const auto quadrant = static_cast<std::int64_t>(k) & 3;
    const bool cosine = (quadrant & 1) != 0;
    double sum = 1.0;
    for (int n = cosine ? 18 : 19; n >= 2; n -= 2)
        sum = 1.0 - r * r / (n * (n - 1)) * sum;
    const double value = cosine ? sum : r * sum;
    return quadrant >= 2 ? -value : value;
}

double cos(double x) {
    return ember::sin(x + 1.5707963267948966);
}

double pow(double x, double y) {
    return ember::exp(y * ember::log(x));
}

}  // namespace ember
