#define EMBER_LANES 4
#define EMBER_FAST 0
#define EMBER_KERNEL_NAME spring_kernel_avx2
#include "sim/kernel/spring_kernel_loops.h"
