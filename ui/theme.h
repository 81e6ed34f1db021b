// The look of the panels.
#pragma once

namespace ember {

/// Sets ImGui's colours, spacing and font for a display scale (1: 96 dpi).
void apply_theme(float scale);

}  // namespace ember
