#include "app/bench/float_traps.h"

#include <algorithm>
#include <cfenv>
#include <csignal>
#include <mutex>

#if defined(__x86_64__) && defined(__linux__) && defined(__GLIBC__)
#include <fenv.h>
#include <ucontext.h>
#define EMBER_FLOAT_TRAPS
extern "C" const char __executable_start;  // by the linker
#endif

namespace ember {

#ifdef EMBER_FLOAT_TRAPS
namespace {

constexpr int kWatched = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;
thread_local std::uintptr_t caught_at = 0;  // instruction of the latest exception, or 0

// Notes the instruction, and lets it run again without exceptions.
void note_exception(int, siginfo_t* info, void* context) {
    constexpr unsigned kAllMasked = 0x1F80, kAllFlags = 0x3F;
    auto* machine = static_cast<ucontext_t*>(context);
    caught_at = reinterpret_cast<std::uintptr_t>(info->si_addr);
    auto* registers = machine->uc_mcontext.fpregs;
    registers->mxcsr = (registers->mxcsr | kAllMasked) & ~kAllFlags;
    registers->cwd = static_cast<std::uint16_t>(registers->cwd | 0x3F);
    registers->swd = static_cast<std::uint16_t>(registers->swd & ~0xFF);
}

void install_handler() {
    struct sigaction action {};
    action.sa_sigaction = note_exception;
    action.sa_flags = SA_SIGINFO;
    ::sigaction(SIGFPE, &action, nullptr);
}

}  // namespace

FloatTraps::FloatTraps() {
    static std::once_flag installed;
    std::call_once(installed, install_handler);
}

FloatTraps::~FloatTraps() {
    ::fedisableexcept(kWatched);
}

bool FloatTraps::available() {
    return true;
}

void FloatTraps::begin(Stage) {
    caught_at = 0;
    std::feclearexcept(FE_ALL_EXCEPT);
    ::feenableexcept(kWatched);
}

void FloatTraps::end(Stage stage) {
    ::fedisableexcept(kWatched);
    if (caught_at == 0) return;
    const std::uintptr_t offset = caught_at - reinterpret_cast<std::uintptr_t>(&__executable_start);
    const bool known = std::any_of(found_.begin(), found_.end(), [&](const FloatTrap& trap) {
        return trap.stage == stage && trap.offset == offset;
    });
    if (!known) found_.push_back({stage, offset});
}

#else

FloatTraps::FloatTraps() = default;
FloatTraps::~FloatTraps() = default;
bool FloatTraps::available() {
    return false;
}
void FloatTraps::begin(Stage) {}
void FloatTraps::end(Stage) {}

#endif

}  // namespace ember
