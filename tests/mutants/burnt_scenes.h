// Pictures of shipped presets, as golden images show them, to see faults of the renderer in.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/camera.h"
#include "render/renderer.h"
#include "sim/world.h"

namespace ember::test {

/// A world at a tick, and how a picture of it is taken.
struct BurntScene {
    std::string name;
    std::shared_ptr<const World> world;
    std::vector<std::vector<SpringSegment>> springs;  ///< where the view shows them
    RenderParams params;
};

/// The scenes, the ones that show most faults first. Simulates them, without any fault. Throws
/// std::runtime_error when a preset has problems.
[[nodiscard]] std::vector<BurntScene> burnt_scenes();

}  // namespace ember::test
