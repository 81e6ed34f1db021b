// Windows that lie over the picture.
#pragma once

#include "ui/panels.h"
#include "ui/paper_tools.h"
#include "ui/plots.h"

namespace ember {

/// Figures, profiler, plots, help, log, and what there is to say.
void draw_overlays(const Layout& layout, Workbench& bench, const PlotData& plots);

/// What is below the mouse on the paper, beside it.
void draw_probe(const PictureCamera& picture, const Snapshot& shot);

}  // namespace ember
