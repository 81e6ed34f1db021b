// Names of numbered files: frame_####.png, frame_%04d.png.
#pragma once

#include <string>

namespace ember {

/// A file name with a place for a number.
class FilePattern {
  public:
    /// Accepts one run of '#' or one "%d" or "%0Nd"; without either, "_####" is put in front of
    /// the extension. Throws InputError for any other '%' and for a second place.
    explicit FilePattern(const std::string& text);

    /// The name for `number`, padded with zeros to the width of the place.
    [[nodiscard]] std::string name(long number) const;

  private:
    std::string before_, after_;
    std::size_t width_ = 4;
};

}  // namespace ember
