// How the shipped presets solve the equations.
#pragma once

#include <string>
#include <vector>

#include "app/bench/work_problem.h"

namespace ember {

enum class PresetKind { Burns, OnlyMoves };  ///< with and without a lighter

/// The different ways in which shipped presets of `kind` ask for the springs to be solved, each
/// with the presets that do so. Presets which differ in nothing that matters share one.
[[nodiscard]] std::vector<WorkPoint> shipped_defaults(PresetKind kind);

}  // namespace ember
