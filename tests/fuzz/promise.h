// What every fuzz target does when a reader breaks its word.
#pragma once

namespace ember {

/// Ends the program as a crash does: what is promised does not hold.
inline void promise(bool holds) {
    if (!holds) __builtin_trap();
}

}  // namespace ember
