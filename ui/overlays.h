// What lies over the picture: statistics, messages, the help sheet.
#pragma once

#include "ui/panels.h"

namespace ember {

/// Draws them over the left `width` points of the window. Closing the help sheet edits the model.
void draw_overlays(PanelModel& model, float width);

}  // namespace ember
