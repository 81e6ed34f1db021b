#include <stdexcept>

#include "golden/stage.h"

namespace ember::golden {

std::unique_ptr<Stage> panel_stage(const std::filesystem::path&, Rasteriser) {
    throw std::runtime_error("built without the window, so without its panels");
}

}  // namespace ember::golden
