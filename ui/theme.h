// The look of the panels.
#pragma once

struct ImVec4;

namespace ember {

/// Sets ImGui's colours, spacing and font for a display scale (1: 96 dpi).
void apply_theme(float scale);

/// Of a lighter's handles in the picture, as ImU32.
[[nodiscard]] unsigned handle_colour(bool edited, bool lit);
[[nodiscard]] ImVec4 error_colour();
[[nodiscard]] ImVec4 warning_colour();

}  // namespace ember
