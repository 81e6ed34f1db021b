#include "app/preset_io/png_text.h"

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace ember {
namespace {

constexpr std::string_view kSignature("\x89PNG\r\n\x1a\n", 8);
constexpr std::uint32_t kLongestText = 1u << 24;  // [bytes]

std::uint32_t number(const char* bytes) {
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i)
        value = value << 8 | static_cast<unsigned char>(bytes[i]);
    return value;
}

// keyword, 0, text
void read_latin(const std::string& data, ImageText& text) {
    const std::size_t end = data.find('\0');
    if (end != std::string::npos) text.emplace_back(data.substr(0, end), data.substr(end + 1));
}

// keyword, 0, compressed or not, method, language, 0, keyword translated, 0, text
void read_international(const std::string& data, ImageText& text) {
    const std::size_t end = data.find('\0');
    if (end == std::string::npos || end + 3 > data.size() || data[end + 1] != 0) return;
    const std::size_t language = data.find('\0', end + 3);
    if (language == std::string::npos) return;
    const std::size_t translated = data.find('\0', language + 1);
    if (translated == std::string::npos) return;
    text.emplace_back(data.substr(0, end), data.substr(translated + 1));
}

}  // namespace

bool is_png(const std::filesystem::path& path) {
    std::array<char, kSignature.size()> start{};
    std::ifstream in(path, std::ios::binary);
    return in.read(start.data(), start.size()) &&
           std::string_view(start.data(), start.size()) == kSignature;
}

ImageText read_png_text(const std::filesystem::path& path) {
    const auto fail = [&path](const std::string& reason) {
        throw std::runtime_error(path.string() + ": " + reason);
    };
    std::ifstream in(path, std::ios::binary);
    if (!in) fail(std::strerror(errno));
    if (!is_png(path)) fail("not a PNG file");
    in.seekg(static_cast<std::streamoff>(kSignature.size()));
    ImageText text;
    for (std::array<char, 8> head{}; in.read(head.data(), head.size());) {
        const std::uint32_t length = number(head.data());
        const std::string_view type(head.data() + 4, 4);
        if (type == "IEND") return text;
        const bool latin = type == "tEXt", international = type == "iTXt";
        if (!latin && !international) {
            in.seekg(length + 4, std::ios::cur);
            continue;
        }
        if (length > kLongestText) fail("a text is longer than any picture of ours has");
        std::string data(length, '\0');
        if (!in.read(data.data(), length)) fail("ends within a text");
        in.seekg(4, std::ios::cur);
        if (latin) read_latin(data, text);
        if (international) read_international(data, text);
    }
    fail("ends before its last chunk");
    return text;
}

const std::string* find_text(const ImageText& text, std::string_view keyword) {
    for (const auto& [key, value] : text) {
        if (key == keyword) return &value;
    }
    return nullptr;
}

}  // namespace ember
