// What every picture of a shot says about how it was made.
#pragma once

#include "app/render_options.h"
#include "render/image.h"

namespace ember {

/// Program and version, preset and where it came from, options, seed, renderer; and "Hash": 16
/// hexadecimal digits over all that decides what a picture of a number and a time looks like. Two
/// pictures with the same hash, frame and time are the same.
[[nodiscard]] ImageText shot_text(const RenderOptions& options, const RenderJob& job,
                                  const std::string& renderer);

/// 64-bit FNV-1a hash of a text.
[[nodiscard]] std::uint64_t text_hash(std::string_view text);

}  // namespace ember
