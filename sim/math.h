// exp, log, pow, sin and cos that give the same bits on every processor (the C library's do not).
#pragma once

namespace ember {

/// e^x to about 1 ulp for |x| <= 700; 0 below -745, +inf above 709.7. NaN stays NaN.
[[nodiscard]] double exp(double x);

/// Natural logarithm of x > 0 to about 2 ulp; NaN for x <= 0 and NaN.
[[nodiscard]] double log(double x);

/// x^y = exp(y log x) for x > 0.
[[nodiscard]] double pow(double x, double y);

/// Sine and cosine for |x| <= 1000, to about 1e-15 absolute.
[[nodiscard]] double sin(double x);
[[nodiscard]] double cos(double x);

}  // namespace ember
