#define EMBER_LANES 8
#define EMBER_FAST 0
#define EMBER_KERNEL_NAME spring_kernel_avx512
#include "sim/kernel/spring_kernel_loops.h"
