// Where the nodes of a sheet are in a picture of it, and what colour the picture has there.
#pragma once

#include <functional>
#include <vector>

#include "render/camera.h"
#include "render/image.h"
#include "render/palette.h"
#include "sim/world_view.h"

namespace ember::test {

struct NodePixel {
    std::size_t node;
    int x, y;  ///< pixel, from the top left corner
};

/// The nodes of the only sheet of `world` that the camera sees: nothing of the sheet is in front of
/// them, and their pixel and its eight neighbours show nothing but the sheet.
[[nodiscard]] std::vector<NodePixel> visible_nodes(const WorldView& world, const Camera& camera,
                                                   int width, int height);

/// Linear RGB of a pixel, without its alpha.
[[nodiscard]] Colour linear_colour(const Image& image, int x, int y);

/// Relative luminance of a linear colour.
[[nodiscard]] inline float luminance(const Colour& c) {
    return 0.2126f * c.x() + 0.7152f * c.y() + 0.0722f * c.z();
}

/// How far `seen` is from being `flat` in more or less shade (0.5 to 1.02 times), relative to the
/// length of `flat`.
[[nodiscard]] float distance_from_shaded(const Colour& seen, const Colour& flat);

/// Of the nodes that `counts`, the share whose pixel `fits`; NaN when there are none.
[[nodiscard]] double share(const std::vector<NodePixel>& nodes,
                           const std::function<bool(std::size_t node)>& counts,
                           const std::function<bool(const NodePixel&)>& fits);

}  // namespace ember::test
