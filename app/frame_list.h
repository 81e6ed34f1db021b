// Lists of frames and times from the command line.
#pragma once

#include <string>
#include <vector>

namespace ember {

/// "0..240", "0..240+5", "1,40,80..90+2", "80..90,+2": ascending, without duplicates.
/// Throws InputError that says what was expected.
[[nodiscard]] std::vector<long> parse_frames(const std::string& text);

/// "0.5,1,2": times [s], ascending. Throws InputError.
[[nodiscard]] std::vector<double> parse_times(const std::string& text);

/// A number of pictures per second as the film world writes it: "30000/1001" is a fraction, 23.976,
/// 29.97 and 59.94 are short for 24000/1001 and so on. Other text is returned as it is.
[[nodiscard]] std::string rate_text(const std::string& text);

/// "960x540". Throws InputError.
struct PictureSize {
    int width = 960, height = 540;
};
[[nodiscard]] PictureSize parse_size(const std::string& text, const std::string& flag = "--size",
                                     const std::string& expected = "WIDTHxHEIGHT");

}  // namespace ember
