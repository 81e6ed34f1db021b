// Films through the ffmpeg program: raw frames into its standard input.
#pragma once

#include <sys/types.h>

#include <filesystem>

#include "render/image.h"

namespace ember {

/// Encodes H.264 MP4. The film appears under its name only when it is complete.
class VideoEncoder {
  public:
    /// Starts ffmpeg. Throws RunError when it cannot be started, and says what to install.
    VideoEncoder(std::filesystem::path path, int width, int height, double fps);
    /// Abandons the film unless finish() has been called.
    ~VideoEncoder();
    VideoEncoder(const VideoEncoder&) = delete;
    VideoEncoder& operator=(const VideoEncoder&) = delete;

    /// Throws RunError with ffmpeg's own words when it has given up.
    void add(const Image& image);
    void finish();

  private:
    [[noreturn]] void fail();
    [[nodiscard]] std::string last_words() const;
    std::filesystem::path path_, temporary_, log_;
    pid_t child_ = -1;
    int input_ = -1;
};

}  // namespace ember
