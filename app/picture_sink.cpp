#include "app/picture_sink.h"

#include <filesystem>

#include "app/exit_code.h"
#include "app/file_pattern.h"
#include "app/preset_io/atomic_file.h"
#include "app/preset_io/parameter_value.h"
#include "app/video_encoder.h"
#include "render/exr_file.h"

namespace ember {
namespace {

// Numbered files.
class FileSink : public PictureSink {
  public:
    FileSink(const std::string& output, const PictureFormat& format)
        : pattern_(output, format.several), text_(format.text) {
        make_folder_of(output);
    }

    void put(const Picture& picture) override {
        ImageText text = text_;
        text.emplace_back("Frame", std::to_string(picture.number));
        text.emplace_back("Time", number_text(picture.time) + " s");
        last_ = pattern_.name(picture.number);
        if (count_++ == 0) first_ = last_;
        write(last_, picture, text);
    }

    void finish() override {}

    std::string where() const override {
        if (count_ == 0) return "no picture";
        if (count_ == 1) return first_;
        return std::to_string(count_) + " pictures: " + first_ + " to " + last_;
    }

  private:
    virtual void write(const std::string& path, const Picture& picture, const ImageText& text) = 0;
    FilePattern pattern_;
    ImageText text_;
    std::string first_, last_;
    long count_ = 0;
};

class PngSink final : public FileSink {
    using FileSink::FileSink;
    void write(const std::string& path, const Picture& picture, const ImageText& text) override {
        write_png(path, picture.image, text);
    }
};

class ExrSink final : public FileSink {
  public:
    using FileSink::FileSink;
    [[nodiscard]] bool wants_layers() const override { return true; }

  private:
    void write(const std::string& path, const Picture& picture, const ImageText& text) override {
        write_exr(path, picture.layers, text);
    }
};

}  // namespace

OutputKind output_kind(const std::string& output) {
    const std::string extension = std::filesystem::path(output).extension().string();
    if (extension == ".mp4") return OutputKind::Mp4;
    if (extension != ".png" && extension != ".exr") {
        throw InputError("-o " + output +
                         ": error: expected a name that ends in .png, .exr or .mp4");
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
        case OutputKind::Mp4:
            break;
    }
    return std::make_unique<VideoEncoder>(output, format);
}

}  // namespace ember
