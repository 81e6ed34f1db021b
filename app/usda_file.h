// Universal Scene Description as text (.usda): meshes, particles and camera with time samples.
#pragma once

#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "app/geometry_frames.h"
#include "render/view_params.h"

namespace ember {

/// A camera of one frame.
struct CameraFrame {
    CameraParams params;
    int width = 16, height = 9;  ///< only their ratio matters
};

struct UsdaScene {
    std::string comment;
    double fps = 24;
    std::vector<long> numbers;  ///< of the frames, ascending: the time codes
    /// Per frame and sheet. When all frames of a sheet have the quads of the first one, its
    /// topology is written once, else with every frame.
    std::vector<KeptFrame> frames;
    std::vector<CameraFrame> cameras;  ///< per frame
    bool particles = true;
};

/// Metres, y up, one mesh per sheet with primvars st, temperature [degC], mass [kg], phase, age
/// [s]; particles as points with widths, ids, temperature and age.
void write_usda(std::ostream& out, const UsdaScene& scene);

}  // namespace ember
