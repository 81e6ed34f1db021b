// The pictures that sheet.mask names.
#pragma once

#include <vector>

#include "app/preset_io/preset_io.h"
#include "sim/params.h"

namespace ember {

/// Reads the picture of every sheet that has one into Params::masks. Returns what is wrong: see
/// read_picture, or a picture without paper. White or grey of at least half is paper.
[[nodiscard]] std::vector<Diagnostic> read_masks(Params& params, const PresetInfo& info);

}  // namespace ember
