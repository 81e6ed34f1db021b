#include "sim/kernel/spring_kernel.h"

#include <initializer_list>

namespace ember {

// EMBER_PLAIN: there are no others, see CMakeLists.txt.
extern const SpringKernel spring_kernel_baseline;
#ifndef EMBER_PLAIN
extern const SpringKernel spring_kernel_avx2, spring_kernel_avx512, spring_kernel_fast;
#endif

SpringKernel spring_kernel_of_width(int lanes) {
#ifndef EMBER_PLAIN
    if (lanes == 0 && __builtin_cpu_supports("avx512f")) return spring_kernel_fast;
    if (lanes == 8 && __builtin_cpu_supports("avx512f")) return spring_kernel_avx512;
    if (lanes == 4 && __builtin_cpu_supports("avx2")) return spring_kernel_avx2;
#endif
    return lanes == 2 ? spring_kernel_baseline : SpringKernel{};
}

SpringKernel spring_kernel(Arithmetic arithmetic) {
    for (const int lanes : {0, 8, 4}) {
        if (lanes == 0 && arithmetic == Arithmetic::Exact) continue;
        const SpringKernel kernel = spring_kernel_of_width(lanes);
        if (kernel.evaluate != nullptr) return kernel;
    }
    return spring_kernel_baseline;
}

}  // namespace ember
