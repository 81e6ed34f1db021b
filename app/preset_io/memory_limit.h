// Whether there is memory for what a preset asks for.
#pragma once

#include <cstdint>

#include "sim/params.h"

namespace ember {

/// Memory that this process may still take [bytes]: the least of what the machine has free, what
/// its control group may have at all, and the limit on address space. The largest number when
/// nothing says.
[[nodiscard]] std::uint64_t free_memory();

/// Throws SceneError with the key when the scene of `params` has more nodes than may be, or more
/// than fit into `bytes`. Makes nothing, so it takes no time.
void check_memory(const Params& params, std::uint64_t bytes = free_memory());

}  // namespace ember
