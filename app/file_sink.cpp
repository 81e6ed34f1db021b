#include "app/file_sink.h"

#include <filesystem>

#include "app/exit_code.h"
#include "app/preset_io/atomic_file.h"
#include "app/preset_io/parameter_value.h"
#include "render/exr_file.h"

namespace ember {

FileSink::FileSink(const std::string& output, const PictureFormat& format)
    : pattern_(output, format.count > 1), text_(format.text) {
    make_folder_of(output);
    remove_stale_temporaries(std::filesystem::path(output).parent_path());
}

ImageText FileSink::text_of(long number, double time) const {
    ImageText text = text_;
    text.emplace_back("Frame", std::to_string(number));
    text.emplace_back("Time", number_text(time) + " s");
    return text;
}

bool FileSink::has(long number, double time) const {
    const std::string path = name(number);
    if (!std::filesystem::exists(path)) return false;
    ImageText found;
    try {
        found = read(path);
    } catch (const std::runtime_error&) {
        return false;  // not whole: drawn again
    }
    const ImageText wanted = text_of(number, time);
    for (const char* keyword : {"Hash", "Frame", "Time"}) {
        const std::string *is = find_text(found, keyword), *should = find_text(wanted, keyword);
        if (is != nullptr && should != nullptr && *is == *should) continue;
        const std::string hint =
            "; emberleaf show tells how it was made. Write elsewhere, remove it, or leave out "
            "--skip-existing";
        throw InputError(path + ": error: made with other settings (" + keyword + ' ' +
                         (is == nullptr ? "missing" : *is) + ", now " +
                         (should == nullptr ? "none" : *should) + ')' + hint);
    }
    return true;
}

void FileSink::put(const Picture& picture) {
    last_ = name(picture.number);
    if (count_++ == 0) first_ = last_;
    write(last_, picture, text_of(picture.number, picture.time));
}

std::string FileSink::where() const {
    if (count_ == 0) return "no new picture";
    if (count_ == 1) return first_;
    return std::to_string(count_) + " pictures: " + first_ + " to " + last_;
}

void PngSink::write(const std::string& path, const Picture& picture, const ImageText& text) {
    write_png(path, picture.image, text);
}

ImageText PngSink::read(const std::string& path) const {
    static_cast<void>(read_image(path));
    return read_png_text(path);
}

std::optional<Image> PngSink::kept(long number) const {
    return read_image(name(number));
}

void ExrSink::write(const std::string& path, const Picture& picture, const ImageText& text) {
    write_exr(path, picture.layers, text);
}

ImageText ExrSink::read(const std::string& path) const {
    static_cast<void>(read_exr(path));  // whether it is complete
    return read_exr_text(path);
}

}  // namespace ember
