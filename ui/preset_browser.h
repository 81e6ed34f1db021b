// Presets to choose from, with pictures.
#pragma once

#include <map>
#include <vector>

#include "render/gl_objects.h"
#include "ui/panels.h"
#include "ui/preset_list.h"

namespace ember {

/// Needs a current GL context in every call, for the pictures.
class PresetBrowser {
  public:
    explicit PresetBrowser(std::filesystem::path cache) : thumbnails_(std::move(cache)) {}
    void draw(const Layout& layout, Workbench& bench);
    /// Goes on with the pictures; returns whether one has been added.
    [[nodiscard]] bool poll();
    [[nodiscard]] bool working() const { return thumbnails_.working(); }

  private:
    void card(const ListedPreset& preset, float width, Workbench& bench);
    [[nodiscard]] const Texture* picture_of(const ListedPreset& preset);
    std::vector<ListedPreset> presets_;
    Thumbnails thumbnails_;
    std::map<std::filesystem::path, Texture> pictures_;
    std::ptrdiff_t waiting_ = 0;
    bool was_open_ = false;
};

}  // namespace ember
