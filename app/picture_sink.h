// Where finished pictures go: numbered PNG files, or a film.
#pragma once

#include <memory>
#include <string>

#include "render/float_image.h"
#include "render/image.h"

namespace ember {

/// A drawn picture and what is known about it.
struct Picture {
    Image image;        ///< empty when no sink wants it
    FloatImage layers;  ///< empty when no sink wants them
    long number = 0;    ///< frame number, as in the file's name
    double time = 0;    ///< [s] in the simulation
};

/// Takes pictures one after the other.
class PictureSink {
  public:
    virtual ~PictureSink() = default;
    /// Whether it takes layers (Renderer::draw_layers) rather than the image.
    [[nodiscard]] virtual bool wants_layers() const { return false; }
    /// Throws RunError or std::runtime_error with the file and the reason.
    virtual void put(const Picture& picture) = 0;
    /// Completes what has been put; without it, an incomplete film is thrown away.
    virtual void finish() = 0;
    /// What there is now and where, for people.
    [[nodiscard]] virtual std::string where() const = 0;
};

/// What a sink must know before the first picture.
struct PictureFormat {
    int width = 0, height = 0;
    double fps = 30;
    bool several = true;  ///< false: a name without a place for the number is taken as it is
    ImageText text;       ///< goes into every PNG, together with "Frame" and "Time"
};

enum class OutputKind { Png, Exr, Mp4 };

/// By the extension of `output`. Throws InputError for any other, for a bad frame pattern, and for
/// EXR when this program was built without it.
[[nodiscard]] OutputKind output_kind(const std::string& output);

/// A sink for `output`. Throws RunError, e.g. when a film is asked for and ffmpeg is not there.
[[nodiscard]] std::unique_ptr<PictureSink> open_sink(const std::string& output,
                                                     const PictureFormat& format);

}  // namespace ember
