// The parameter table of the simulation: the one place that knows keys, units, ranges and meaning.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/param_info.h"
#include "sim/params.h"

namespace ember {

/// All rows, in the order in which people should meet them.
[[nodiscard]] std::span<const ParamInfo> sim_param_rows();

/// The table bound to one object; `params` must outlive the binding.
[[nodiscard]] ParamBinding bind(Params& params);

/// What a change of parameters asks for.
enum class ParamChange { None, Live, Rebuild };
[[nodiscard]] ParamChange compare(const Params& a, const Params& b);

/// What no range can express, one sentence each, e.g. a flame too cold to light anything.
/// Such a scene runs, but probably not as meant. Shown by `check`, the window and the log.
[[nodiscard]] std::vector<std::string> plausibility_warnings(const Params& params);

/// Sheet thickness [m] = grammage / density.
[[nodiscard]] constexpr double caliper(const PaperParams& paper) {
    return paper.grammage / paper.density;
}

}  // namespace ember
