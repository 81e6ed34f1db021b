// The panels: which parameters stand where. They edit copies and say what a person asked for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/view_params.h"
#include "sim/params.h"
#include "ui/bindings.h"
#include "ui/lighter_placement.h"
#include "ui/session.h"
#include "ui/speedometer.h"

namespace ember {

/// Copies that the panels edit, and values that they show.
struct PanelModel {
    Params params, preset_params;
    RenderParams render, preset_render;
    std::string title;  ///< of the preset
    SessionStats stats;
    FrameTimes times;
    std::string message;                ///< what has gone wrong; empty when nothing has
    std::vector<std::string> warnings;  ///< what is probably not meant
    bool playing = false, placing = false;
    bool show_panel = true, show_statistics = true, show_help = false;
};

/// What a person asked for with the panels.
struct PanelRequests {
    bool apply_params = false;     ///< PanelModel::params holds an edit to apply
    std::optional<Action> action;  ///< a button that stands for a key
    std::optional<LighterSpot> lighter_spot;
    bool light_now = false;
};

/// Width of the main panel at the right edge of the window [points]; the picture has the rest.
[[nodiscard]] float panel_width(const PanelModel& model);

/// Lays out all panels for one frame.
[[nodiscard]] PanelRequests draw_panels(PanelModel& model);

}  // namespace ember
