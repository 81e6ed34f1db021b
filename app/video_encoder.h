// Films, through the ffmpeg program: raw pictures go into its standard input.
#pragma once

#include <sys/types.h>

#include <filesystem>

#include "app/picture_sink.h"

namespace ember {

/// A film of the kind that the name's extension tells (film_format.h). It appears under its name
/// when it is complete.
class VideoEncoder final : public PictureSink {
  public:
    /// Starts ffmpeg. Throws RunError when it is not installed.
    VideoEncoder(std::filesystem::path path, const PictureFormat& format);
    /// Ends ffmpeg and removes the incomplete file, unless finish() has been called.
    ~VideoEncoder() override;
    VideoEncoder(const VideoEncoder&) = delete;
    VideoEncoder& operator=(const VideoEncoder&) = delete;

    /// Throws RunError with the last lines that ffmpeg printed when it has failed.
    void put(const Picture& picture) override;
    void finish() override;
    [[nodiscard]] std::string where() const override;

  private:
    void start(const PictureFormat& format);
    [[noreturn]] void fail(const std::string& reason);
    int wait_for_end();

    std::filesystem::path path_, temporary_;
    int pipe_ = -1;  ///< our end of its standard input
    int log_ = -1;   ///< an unnamed file that holds its standard error
    pid_t process_ = -1;
    bool finished_ = false;
};

}  // namespace ember
