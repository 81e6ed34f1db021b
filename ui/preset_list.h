// The presets that there are, and small pictures of them that the program draws itself.
#pragma once

#include <deque>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "ui/child_process.h"

namespace ember {

struct ListedPreset {
    std::string name;  ///< "paper/corner", or the name of one's own
    std::string title;
    std::filesystem::path path;
    bool own = false;  ///< saved by hand
};

/// One's own in `folder` first, then those that come with the program; files that are no presets
/// are left out.
[[nodiscard]] std::vector<ListedPreset> list_presets(const std::filesystem::path& folder);

/// Draws thumbnails one after the other, each by a child at low priority, and keeps them.
class Thumbnails {
  public:
    explicit Thumbnails(std::filesystem::path cache) : cache_(std::move(cache)) {}
    /// Asks for those that are missing.
    void want(const std::vector<ListedPreset>& presets);
    /// Goes on; call now and then.
    void poll();
    /// The picture of a preset as its file is now, or empty while there is none.
    [[nodiscard]] std::filesystem::path file_of(const std::filesystem::path& preset) const;
    [[nodiscard]] bool working() const { return child_ != nullptr || !queue_.empty(); }
    void stop() { queue_.clear(); }

  private:
    [[nodiscard]] std::filesystem::path name_of(const std::filesystem::path& preset) const;
    std::filesystem::path cache_;
    std::deque<std::filesystem::path> queue_;
    std::unique_ptr<ChildProcess> child_;
};

}  // namespace ember
