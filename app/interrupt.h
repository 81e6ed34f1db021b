// SIGINT and SIGTERM: finish the frame, leave everything valid, then end.
#pragma once

namespace ember {

/// From now on the first such signal is only noted; a second one ends the program at once.
void watch_for_interrupts();

/// The signal that has arrived, or 0.
[[nodiscard]] int interrupt_signal();

}  // namespace ember
