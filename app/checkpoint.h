// A simulation on disk, to go on with it later or elsewhere.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "app/run_options.h"
#include "sim/world.h"

namespace ember {

/// The whole state of `world`, with the hashes of its parameters and of itself: what a checkpoint
/// holds (checkpoint_format.h).
[[nodiscard]] std::string checkpoint_bytes(const World& world, const LoadedPreset& preset);

/// Gives `world` the state in `bytes`. Throws std::runtime_error with the reason, and leaves the
/// world as it is, when they are none of ours, not whole, damaged, or made with other parameters of
/// the simulation or by another version of the program.
void resume_from(std::string_view bytes, World& world, const LoadedPreset& preset);

/// Writes checkpoint_bytes() to `path`. Throws std::runtime_error.
void save_checkpoint(const std::filesystem::path& path, const World& world,
                     const LoadedPreset& preset);

/// resume_from() the file `path`. Throws InputError.
void load_checkpoint(const std::filesystem::path& path, World& world, const LoadedPreset& preset);

}  // namespace ember
