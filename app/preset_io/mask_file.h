// The pictures that sheet.mask names.
#pragma once

#include <vector>

#include "app/preset_io/preset_io.h"
#include "sim/params.h"

namespace ember {

/// Reads the picture of every sheet that has one into Params::masks. A name is a path within the
/// folder of the preset that says it (of the preset that is run, for --set). Returns what is wrong:
/// a path that leads out of that folder, no PNG, or one of a single pixel or of more than
/// kMostMaskPixels, which is refused before it is decoded. White or grey of at least half is paper.
[[nodiscard]] std::vector<Diagnostic> read_masks(Params& params, const PresetInfo& info);

inline constexpr std::uint64_t kMostMaskPixels = 8192ull * 8192ull;

}  // namespace ember
