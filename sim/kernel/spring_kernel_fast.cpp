#define EMBER_LANES 8
#define EMBER_FAST 1
#define EMBER_KERNEL_NAME spring_kernel_fast
#include "sim/kernel/spring_kernel_loops.h"
