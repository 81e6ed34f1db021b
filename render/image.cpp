#include "render/image.h"

#include <fcntl.h>
#include <stb_image.h>
#include <stb_image_write.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>
#include <stdexcept>

namespace ember {
namespace {

using Bytes = std::vector<unsigned char>;

constexpr std::ptrdiff_t kSignature = 8;     // bytes of the PNG signature
constexpr std::ptrdiff_t kHeaderChunk = 25;  // length, "IHDR", 13 bytes, CRC
constexpr std::size_t kAroundData = 12;      // length, type and CRC of a chunk

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
    throw std::runtime_error(path.string() + ": " + reason);
}

// CRC-32 of the PNG specification (ISO 3309), a byte at a time without a table.
std::uint32_t crc32(const unsigned char* bytes, std::size_t count) {
    std::uint32_t crc = 0xFFFFFFFFu;
    for (std::size_t i = 0; i < count; ++i) {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc >> 1) ^ (0xEDB88320u & (0u - (crc & 1u)));
    }
    return ~crc;
}

void put32(Bytes& out, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) {
        out.push_back(static_cast<unsigned char>(value >> shift & 0xFFu));
    }
}

std::uint32_t get32(const Bytes& in, std::size_t at) {
    return static_cast<std::uint32_t>(in[at]) << 24 | static_cast<std::uint32_t>(in[at + 1]) << 16 |
           static_cast<std::uint32_t>(in[at + 2]) << 8 | static_cast<std::uint32_t>(in[at + 3]);
}

void put_text_chunk(Bytes& out, const std::string& keyword, const std::string& text) {
    put32(out, static_cast<std::uint32_t>(keyword.size() + 1 + text.size()));
    const std::size_t type = out.size();
    for (const char c : std::string("tEXt") + keyword)
        out.push_back(static_cast<unsigned char>(c));
    out.push_back(0);
    for (const char c : text)
        out.push_back(static_cast<unsigned char>(c));
    put32(out, crc32(out.data() + type, out.size() - type));
}

Bytes encode(const Image& image, const ImageText& text) {
    Bytes png;
    const auto append = [](void* context, void* data, int size) {
        const auto* bytes = static_cast<const unsigned char*>(data);
        static_cast<Bytes*>(context)->insert(static_cast<Bytes*>(context)->end(), bytes,
                                             bytes + size);
    };
    if (stbi_write_png_to_func(append, &png, image.width, image.height, 4, image.rgba.data(),
                               image.width * 4) == 0) {
        throw std::runtime_error("out of memory while encoding a PNG");
    }
    const auto split = png.begin() + kSignature + kHeaderChunk;
    Bytes out(png.begin(), split);
    for (const auto& [keyword, value] : text)
        put_text_chunk(out, keyword, value);
    out.insert(out.end(), split, png.end());
    return out;
}

// Writes all bytes and makes them durable; the caller removes the file when this throws.
void write_all(const std::filesystem::path& path, const Bytes& bytes) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (file < 0) fail(path, std::strerror(errno));
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t count = ::write(file, bytes.data() + done, bytes.size() - done);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) {
            const std::string reason = std::strerror(errno);
            ::close(file);
            fail(path, reason);
        }
        done += static_cast<std::size_t>(count);
    }
    const bool synced = ::fsync(file) == 0;
    const std::string reason = synced ? "" : std::strerror(errno);
    if (::close(file) != 0 || !synced) fail(path, synced ? std::strerror(errno) : reason);
}

Bytes read_all(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) fail(path, std::strerror(errno));
    return Bytes(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

}  // namespace

void write_png(const std::filesystem::path& path, const Image& image, const ImageText& text) {
    if (image.width <= 0 || image.height <= 0 ||
        image.rgba.size() != std::size_t(image.width) * std::size_t(image.height) * 4) {
        fail(path, "image has no pixels");
    }
    const Bytes bytes = encode(image, text);
    std::filesystem::path temporary = path;
    temporary += ".tmp-" + std::to_string(::getpid());
    try {
        write_all(temporary, bytes);
        std::filesystem::rename(temporary, path);
    } catch (const std::exception& e) {
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        fail(path, std::string("cannot write: ") + e.what());
    }
}

Image read_image(const std::filesystem::path& path) {
    const Bytes bytes = read_all(path);
    Image image;
    int channels = 0;
    const std::unique_ptr<unsigned char, void (*)(void*)> pixels(
        stbi_load_from_memory(bytes.data(), static_cast<int>(bytes.size()), &image.width,
                              &image.height, &channels, 4),
        stbi_image_free);
    if (!pixels) fail(path, std::string("not an image: ") + stbi_failure_reason());
    image.rgba.assign(pixels.get(),
                      pixels.get() + std::size_t(image.width) * std::size_t(image.height) * 4);
    return image;
}

ImageText read_png_text(const std::filesystem::path& path) {
    const Bytes bytes = read_all(path);
    ImageText text;
    auto at = static_cast<std::size_t>(kSignature);
    while (at + kAroundData <= bytes.size()) {
        const std::size_t length = get32(bytes, at);
        if (length > bytes.size() - at - kAroundData) fail(path, "a chunk is longer than the file");
        const auto* begin = reinterpret_cast<const char*>(bytes.data() + at + 8);
        if (std::memcmp(bytes.data() + at + 4, "tEXt", 4) == 0) {
            const std::string data(begin, length);
            const std::size_t zero = data.find('\0');
            if (zero != std::string::npos) {
                text.emplace_back(data.substr(0, zero), data.substr(zero + 1));
            }
        }
        at += length + kAroundData;
    }
    return text;
}

}  // namespace ember
