// Names of numbered files: frame_####.png, frame_%04d.png, frame_{frame:4}.png.
#pragma once

#include <string>

namespace ember {

/// A file name with a place for a number.
class FilePattern {
  public:
    /// Accepts one run of '#' or one "%d", "%0Nd", "{frame}" or "{frame:N}" in the file's name;
    /// without either, "_####" is
    /// put in front of the extension if there are `several` files. Throws InputError for any
    /// other '%' and for a second place.
    explicit FilePattern(const std::string& text, bool several = true);

    /// The name for `number`, padded with zeros to the width of the place.
    [[nodiscard]] std::string name(long number) const;

  private:
    std::string before_, after_;
    std::size_t width_ = 4;
    bool numbered_ = true;
};

}  // namespace ember
