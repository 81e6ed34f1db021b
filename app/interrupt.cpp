#include "app/interrupt.h"

#include <csignal>
#include <cstdlib>

namespace ember {
namespace {

volatile std::sig_atomic_t arrived = 0;

extern "C" void note_signal(int number) {
    if (arrived != 0) std::_Exit(128 + number);
    arrived = number;
}

}  // namespace

void watch_for_interrupts() {
    std::signal(SIGINT, note_signal);
    std::signal(SIGTERM, note_signal);
    std::signal(SIGPIPE, SIG_IGN);  // a child that ends early is reported by write() instead
    std::signal(SIGXFSZ, SIG_IGN);  // and so is a file that may not grow
}

int interrupt_signal() {
    return arrived;
}

}  // namespace ember
