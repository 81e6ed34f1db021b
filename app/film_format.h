// The films that the ffmpeg program makes for us.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/picture_sink.h"

namespace ember {

struct FilmFormat {
    std::string_view extension;  ///< ".mp4"
    bool alpha;                  ///< keeps what is transparent
    std::string_view arguments;  ///< of ffmpeg, between input and output, with spaces between
};

/// The format of that extension, or null.
[[nodiscard]] const FilmFormat* find_film_format(std::string_view extension);

/// ", .mp4, .mov or ..."
[[nodiscard]] std::string film_extensions();

/// The command that reads raw RGBA pictures from standard input and writes `output`.
[[nodiscard]] std::vector<std::string> ffmpeg_command(const FilmFormat& film,
                                                      const PictureFormat& format,
                                                      const std::string& output);

}  // namespace ember
