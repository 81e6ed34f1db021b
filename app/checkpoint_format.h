// The bytes of a saved simulation.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "sim/world_state.h"

namespace ember {

/// What a saved simulation says. As bytes it is a line with the number of the format, then
/// sections: HEAD, one SHEE for each sheet, FIRE and LEDG. A section is its four letters, the
/// length of its contents (64 bits), the contents, and the CRC-32 of all three. All numbers are
/// little endian on every machine, an array is its length (64 bits) and its elements.
struct SavedState {
    std::string program;           ///< version of the program that saved it
    std::uint64_t parameters = 0;  ///< hash of the parameters of the simulation
    WorldState state;
};

[[nodiscard]] std::string saved_bytes(const std::string& program, std::uint64_t parameters,
                                      const WorldState& state);

/// Reads what saved_bytes() has made. Throws std::runtime_error with the reason when that is
/// another format, not whole, or damaged: no array is made before its section's CRC is right.
[[nodiscard]] SavedState read_saved_bytes(std::string_view bytes);

/// Why `state` cannot be one of a world whose state at the start is `like`: arrays of another
/// length, or indices that point to nothing. Empty when it can.
[[nodiscard]] std::string misfit(const WorldState& state, const WorldState& like);

}  // namespace ember
