// A simulation on disk, to go on with it later or elsewhere.
#pragma once

#include <filesystem>

#include "app/run_options.h"
#include "sim/world.h"

namespace ember {

/// Writes the whole state of `world`, with the hashes of its parameters and of itself. Little
/// endian, for this version of the program. Throws std::runtime_error.
void save_checkpoint(const std::filesystem::path& path, const World& world,
                     const LoadedPreset& preset);

/// Gives `world` the state in `path`. Throws InputError when the file is none of ours, is not
/// whole, or was made with other parameters of the simulation.
void load_checkpoint(const std::filesystem::path& path, World& world, const LoadedPreset& preset);

}  // namespace ember
