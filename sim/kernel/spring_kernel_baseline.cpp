#define EMBER_LANES 2
#define EMBER_FAST 0
#define EMBER_KERNEL_NAME spring_kernel_baseline
#include "sim/kernel/spring_kernel_loops.h"
