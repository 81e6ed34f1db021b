#include "app/picture_sink.h"

#include <filesystem>

#include "app/atomic_file.h"
#include "app/exit_code.h"
#include "app/file_pattern.h"
#include "app/preset_io/parameter_value.h"
#include "app/video_encoder.h"

namespace ember {
namespace {

class PngSink final : public PictureSink {
  public:
    PngSink(const std::string& output, const PictureFormat& format)
        : pattern_(output, format.several), text_(format.text) {
        make_folder_of(output);
    }

    void put(const Picture& picture) override {
        ImageText text = text_;
        text.emplace_back("Frame", std::to_string(picture.number));
        text.emplace_back("Time", number_text(picture.time) + " s");
        last_ = pattern_.name(picture.number);
        if (count_++ == 0) first_ = last_;
        write_png(last_, picture.image, text);
    }

    void finish() override {}

    std::string where() const override {
        if (count_ == 0) return "no picture";
        if (count_ == 1) return first_;
        return std::to_string(count_) + " pictures: " + first_ + " to " + last_;
    }

  private:
    FilePattern pattern_;
    ImageText text_;
    std::string first_, last_;
    long count_ = 0;
};

}  // namespace

OutputKind output_kind(const std::string& output) {
    const std::string extension = std::filesystem::path(output).extension().string();
    if (extension == ".mp4") return OutputKind::Mp4;
    if (extension != ".png") {
        throw InputError("-o " + output + ": error: expected a name that ends in .png or .mp4");
    }
    const FilePattern checked(output);
    return OutputKind::Png;
}

std::unique_ptr<PictureSink> open_sink(const std::string& output, const PictureFormat& format) {
    if (output_kind(output) == OutputKind::Png) {
        return std::make_unique<PngSink>(output, format);
    }
    return std::make_unique<VideoEncoder>(output, format);
}

}  // namespace ember
