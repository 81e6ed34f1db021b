// How a stopped simulation is reported.
#pragma once

#include <cstdio>
#include <string>

#include "sim/step_stats.h"

namespace ember {

/// One line: time, stage, sheet and node, reason.
[[nodiscard]] inline std::string diverged_text(const StepReport& report) {
    char text[400];
    std::snprintf(text, sizeof text,
                  "the simulation stopped at t = %.4f s in stage %s (sheet %d, node %d) after %d "
                  "retries: %s",
                  report.time,
                  std::string(kStageNames[static_cast<std::size_t>(report.stage)]).c_str(),
                  report.sheet, report.node, report.retries, report.reason.c_str());
    return text;
}

}  // namespace ember
