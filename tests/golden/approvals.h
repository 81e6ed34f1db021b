// What has been approved of a suite of scenes: one JSON file per suite, and a PNG per scene.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render/image.h"

namespace ember::golden {

/// What may change the bits of a picture besides the program.
struct Environment {
    std::string renderer;  ///< GL_RENDERER and GL_VERSION, with LLVM's and Mesa's version
    std::string cpu_caps;  ///< what the rasteriser was told that the processor can do, or "all"
    friend bool operator==(const Environment&, const Environment&) = default;
    [[nodiscard]] std::string text() const { return renderer + ", instructions " + cpu_caps; }
};

/// Names and counts; deterministic.
using Work = std::vector<std::pair<std::string, std::int64_t>>;

/// One picture that was looked at and found right.
struct Approval {
    std::uint64_t pixels = 0;  ///< hash
    Environment environment;
    std::string reason, commit;
};

/// What a scene looks like. The PNG beside the file is the first approval's.
struct Golden {
    std::uint64_t parameters = 0;  ///< hash of the simulation's parameters
    std::uint64_t state = 0;       ///< hash of the state that the picture shows
    std::vector<Approval> approved;
    Work work;
};

/// The goldens of one suite, by scene name.
using Goldens = std::map<std::string, Golden>;

class ApprovedFolder {
  public:
    explicit ApprovedFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}
    /// Empty when there are none. Throws std::runtime_error when the file is damaged.
    [[nodiscard]] Goldens read(const std::string& suite) const;
    /// Writes the file unless it holds the same already.
    void write(const std::string& suite, const Goldens& goldens) const;
    /// The picture of a scene, if there is one.
    [[nodiscard]] std::optional<Image> picture(const std::string& full_name) const;
    void write_picture(const std::string& full_name, const Image& image) const;
    void remove_picture(const std::string& full_name) const;
    [[nodiscard]] const std::filesystem::path& path() const { return folder_; }

  private:
    std::filesystem::path folder_;
};

}  // namespace ember::golden
