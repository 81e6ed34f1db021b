#include "app/picture_sink.h"

#include <filesystem>

#include "app/exit_code.h"
#include "app/file_pattern.h"
#include "app/file_sink.h"
#include "app/film_format.h"
#include "app/raw_sink.h"
#include "app/video_encoder.h"
#include "render/exr_file.h"

namespace ember {

OutputKind output_kind(const std::string& output) {
    if (output == "-") return OutputKind::Raw;
    const std::string extension = std::filesystem::path(output).extension().string();
    if (find_film_format(extension) != nullptr) return OutputKind::Film;
    if (extension != ".png" && extension != ".exr") {
        throw InputError("-o " + output +
                         ": error: expected - for standard output, or a name that " +
                         "ends in .png, .exr" + film_extensions());
    }
    if (extension == ".exr" && !exr_available()) {
        throw InputError("-o " + output +
                         ": error: this emberleaf was built without OpenEXR; install it (on "
                         "Debian: sudo apt install libopenexr-dev) and build again");
    }
    const FilePattern checked(output);
    return extension == ".exr" ? OutputKind::Exr : OutputKind::Png;
}

std::unique_ptr<PictureSink> open_sink(const std::string& output, const PictureFormat& format) {
    switch (output_kind(output)) {
        case OutputKind::Png:
            return std::make_unique<PngSink>(output, format);
        case OutputKind::Exr:
            return std::make_unique<ExrSink>(output, format);
        case OutputKind::Raw:
            return std::make_unique<RawSink>();
        case OutputKind::Film:
            break;
    }
    return std::make_unique<VideoEncoder>(output, format);
}

double estimated_bytes(OutputKind kind, int width, int height) {
    // measured on the built-in presets in mid-burn
    constexpr double kPng = 0.8, kExr = 6.0, kRaw = 4.0;  // [bytes per pixel]
    const double pixels = static_cast<double>(width) * height;
    switch (kind) {
        case OutputKind::Png:
            return kPng * pixels;
        case OutputKind::Exr:
            return kExr * pixels;
        case OutputKind::Raw:
            return kRaw * pixels;
        case OutputKind::Film:
            break;
    }
    return 0;
}

}  // namespace ember
