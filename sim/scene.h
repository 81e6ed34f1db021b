// What exists in a scene: the recipe from which a world is built. Never changes afterwards.
#pragma once

#include <vector>

#include "sim/params.h"
#include "sim/types.h"

namespace ember {

/// One sheet before it is built. Local frame: main direction along `main`, cross along `cross`.
struct SheetPlan {
    int rows = 0, columns = 0;     ///< cells in cross (M) and main (N) direction
    double width = 0, height = 0;  ///< [m] cross and main size
    SheetShape shape = SheetShape::Flat;
    Border border = Border::Tributary;
    HeldEdge held = HeldEdge::None;
    Vector3 origin = Vector3::Zero();  ///< [m] of site (row 0, column 0)
    Vector3 main = Vector3::UnitX();   ///< unit vector
    Vector3 cross = Vector3::UnitZ();  ///< unit vector; on a tube, the direction at row 0
    double imperfection = 0;           ///< [m] amplitude of the initial waviness
};

/// Sheets; lighters are parameters, because they are moved while the paper burns.
struct Scene {
    std::vector<SheetPlan> sheets;
};

/// The scene that the sheet group of `params` describes.
[[nodiscard]] Scene make_scene(const SheetParams& params);

}  // namespace ember
