#include "render/image.h"

#include <png.h>

#include <algorithm>
#include <cerrno>
#include <csetjmp>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "app/preset_io/atomic_file.h"

namespace ember {
namespace {

// Of a picture of 1920x1080, a fifth of the time and half as much again in size as the library's
// own choice.
constexpr int kCompression = 1;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
    throw std::runtime_error(path.string() + ": " + reason);
}

// The library reports errors by a jump: no object with a destructor may be made on its way, so all
// that it works with is here.
struct Coder {
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::string bytes;     // of the file
    std::size_t read = 0;  // of them
    std::string error;     // why it has failed
    std::vector<png_bytep> rows;

    static void on_error(png_structp png, png_const_charp message) {
        static_cast<Coder*>(png_get_error_ptr(png))->error = message;
        png_longjmp(png, 1);
    }
    static void on_warning(png_structp, png_const_charp) {}
    static void on_write(png_structp png, png_bytep data, std::size_t count) {
        static_cast<Coder*>(png_get_io_ptr(png))
            ->bytes.append(reinterpret_cast<const char*>(data), count);
    }
    static void on_read(png_structp png, png_bytep data, std::size_t count) {
        auto* coder = static_cast<Coder*>(png_get_io_ptr(png));
        if (count > coder->bytes.size() - coder->read) png_error(png, "the file is not whole");
        std::memcpy(data, coder->bytes.data() + coder->read, count);
        coder->read += count;
    }
};

bool is_ascii(const std::string& text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return c > 0; });
}

std::vector<png_text> chunks(const ImageText& text) {
    std::vector<png_text> all;
    for (const auto& [keyword, value] : text) {
        png_text chunk{};
        chunk.compression = is_ascii(value) ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
        chunk.key = const_cast<png_charp>(keyword.c_str());
        chunk.text = const_cast<png_charp>(value.c_str());
        chunk.text_length = value.size();
        all.push_back(chunk);
    }
    return all;
}

bool write_chunks(Coder& coder, const Image& image, std::vector<png_text>& text) {
    if (setjmp(png_jmpbuf(coder.png)) != 0) return false;
    png_set_write_fn(coder.png, &coder, Coder::on_write, nullptr);
    png_set_IHDR(coder.png, coder.info, static_cast<png_uint_32>(image.width),
                 static_cast<png_uint_32>(image.height), 8, PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(coder.png, coder.info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_text(coder.png, coder.info, text.data(), static_cast<int>(text.size()));
    png_set_filter(coder.png, 0, PNG_FILTER_SUB);
    png_set_compression_level(coder.png, kCompression);
    png_write_info(coder.png, coder.info);
    png_write_image(coder.png, coder.rows.data());
    png_write_end(coder.png, nullptr);
    return true;
}

bool read_head(Coder& coder) {
    if (setjmp(png_jmpbuf(coder.png)) != 0) return false;
    png_set_read_fn(coder.png, &coder, Coder::on_read);
    png_set_crc_action(coder.png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
    png_read_info(coder.png, coder.info);
    png_set_expand(coder.png);
    png_set_strip_16(coder.png);
    png_set_gray_to_rgb(coder.png);
    png_set_filler(coder.png, 0xFF, PNG_FILLER_AFTER);
    static_cast<void>(png_set_interlace_handling(coder.png));
    png_read_update_info(coder.png, coder.info);
    return true;
}

bool read_rows(Coder& coder) {
    if (setjmp(png_jmpbuf(coder.png)) != 0) return false;
    png_read_image(coder.png, coder.rows.data());
    png_read_end(coder.png, nullptr);
    return true;
}

void point_at_rows(Coder& coder, const std::uint8_t* pixels, int width, int height) {
    coder.rows.resize(static_cast<std::size_t>(height));
    for (std::size_t y = 0; y < coder.rows.size(); ++y)
        coder.rows[y] = const_cast<png_bytep>(pixels) + y * static_cast<std::size_t>(width) * 4;
}

}  // namespace

std::string encode_png(const Image& image, const ImageText& text) {
    if (image.width <= 0 || image.height <= 0 ||
        image.rgba.size() != std::size_t(image.width) * std::size_t(image.height) * 4) {
        throw std::runtime_error("image has no pixels");
    }
    Coder coder;
    std::vector<png_text> all = chunks(text);
    point_at_rows(coder, image.rgba.data(), image.width, image.height);
    coder.png =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, &coder, Coder::on_error, Coder::on_warning);
    coder.info = png_create_info_struct(coder.png);
    const bool good = write_chunks(coder, image, all);
    png_destroy_write_struct(&coder.png, &coder.info);
    if (!good) throw std::runtime_error("PNG: " + coder.error);
    return std::move(coder.bytes);
}

void write_png(const std::filesystem::path& path, const Image& image, const ImageText& text) {
    std::string bytes;
    try {
        bytes = encode_png(image, text);
    } catch (const std::runtime_error& e) {
        fail(path, e.what());
    }
    write_file(path, bytes);
}

Image read_image(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) fail(path, std::strerror(errno));
    if (!is_png(path)) fail(path, "not a PNG file");
    Coder coder;
    coder.bytes.assign(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    coder.png =
        png_create_read_struct(PNG_LIBPNG_VER_STRING, &coder, Coder::on_error, Coder::on_warning);
    coder.info = png_create_info_struct(coder.png);
    Image image;
    bool good = read_head(coder);
    if (good) {
        image.width = static_cast<int>(png_get_image_width(coder.png, coder.info));
        image.height = static_cast<int>(png_get_image_height(coder.png, coder.info));
        image.rgba.resize(std::size_t(image.width) * std::size_t(image.height) * 4);
        point_at_rows(coder, image.rgba.data(), image.width, image.height);
        good = read_rows(coder);
    }
    png_destroy_read_struct(&coder.png, &coder.info, nullptr);
    if (!good) fail(path, coder.error);
    return image;
}

}  // namespace ember
