// e^x of a whole array at once.
#pragma once

#include <cstddef>

namespace ember {

/// Replaces each of `count` values by e^x, to about 1 ulp for -708 <= x <= 709; 0 below. NaN stays
/// NaN. The same bits for any vector width; they may differ from ember::exp in the last place,
/// because a division per term would not pay here.
void exp_array(double* values, std::ptrdiff_t count);

}  // namespace ember
