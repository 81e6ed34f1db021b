// The panels: which parameters stand where, statistics, help. They edit copies and return them.
#pragma once

#include <string>

#include "render/view_params.h"
#include "sim/params.h"
#include "ui/session.h"

namespace ember {

/// Copies that the panels edit, and what they are compared with.
struct PanelModel {
    Params params, preset_params;
    RenderParams render, preset_render;
    std::string title;  ///< of the preset
    SessionStats stats;
    std::string message;
    bool playing = false;
    double frame_ms = 0;
    bool show_panel = true, show_help = false;
};

/// What a person asked for with the panels.
struct PanelRequests {
    bool params_changed = false;  ///< PanelModel::params holds an edit to apply
    bool toggle_play = false, step = false, restart = false;
};

/// Lays out all panels for one frame.
[[nodiscard]] PanelRequests draw_panels(PanelModel& model);

}  // namespace ember
