// Where finished pictures go: numbered files, a film, one large picture, or standard output.
#pragma once

#include <memory>
#include <optional>
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
    /// Whether the picture is there already: whole, and made with the same settings. Throws
    /// InputError when it is there but was made with others.
    [[nodiscard]] virtual bool has(long /*number*/, double /*time*/) const { return false; }
    /// The image that has() has found, for sinks that have it not; empty when it keeps no images.
    [[nodiscard]] virtual std::optional<Image> kept(long /*number*/) const { return std::nullopt; }
    /// Throws std::runtime_error with the file and the reason.
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
    long count = 1;    ///< of pictures; a single one needs no place for the number in its name
    ImageText text;    ///< goes into every picture, together with "Frame" and "Time"
    std::string grid;  ///< "COLUMNSxROWS" of a sprite sheet; empty: as square as can be
};

enum class OutputKind { Png, Exr, Film, Raw };

/// By the extension of `output`; "-" is standard output. Throws InputError for any other, for a bad
/// frame pattern, and for EXR when this program was built without it.
[[nodiscard]] OutputKind output_kind(const std::string& output);

/// A sink for `output`. Throws, e.g. when a film is asked for and ffmpeg is not there.
[[nodiscard]] std::unique_ptr<PictureSink> open_sink(const std::string& output,
                                                     const PictureFormat& format);

/// About how many bytes one picture takes, for kinds whose size can be told beforehand; else 0.
[[nodiscard]] double estimated_bytes(OutputKind kind, int width, int height);

}  // namespace ember
