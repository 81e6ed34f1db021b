#include "render/exr_file.h"

#ifdef EMBERLEAF_WITH_EXR
#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <half.h>
#endif

#include <stdexcept>

#include "app/preset_io/atomic_file.h"

namespace ember {

#ifdef EMBERLEAF_WITH_EXR
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
    throw std::runtime_error(path.string() + ": " + reason);
}

// Half has three digits, too few for these.
bool needs_float(const std::string& channel) {
    return channel == "depth.Z" || channel == "temperature.T";
}

Imf::Slice slice(Imf::PixelType type, void* values, std::size_t size, int width) {
    return {type, static_cast<char*>(values), size, size * static_cast<std::size_t>(width)};
}

void write(const std::string& name, const FloatImage& image, const ImageText& text) {
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const auto& [keyword, value] : text)
        header.insert(keyword, Imf::StringAttribute(value));
    Imf::FrameBuffer pixels;
    std::vector<std::vector<half>> halves;
    halves.reserve(image.channels.size());  // slices point into it
    for (const auto& [channel, values] : image.channels) {
        if (needs_float(channel)) {
            header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
            pixels.insert(channel, slice(Imf::FLOAT, const_cast<float*>(values.data()),
                                         sizeof(float), image.width));
            continue;
        }
        halves.emplace_back(values.begin(), values.end());
        header.channels().insert(channel, Imf::Channel(Imf::HALF));
        pixels.insert(channel, slice(Imf::HALF, halves.back().data(), sizeof(half), image.width));
    }
    Imf::OutputFile file(name.c_str(), header);
    file.setFrameBuffer(pixels);
    file.writePixels(image.height);
}

}  // namespace

bool exr_available() {
    return true;
}

void write_exr(const std::filesystem::path& path, const FloatImage& image, const ImageText& text) {
    const std::filesystem::path temporary = temporary_name(path);
    try {
        write(temporary.string(), image, text);
    } catch (const std::exception& e) {
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        fail(path, std::string("cannot write: ") + e.what());
    }
    publish_file(temporary, path);
}

ImageText read_exr_text(const std::filesystem::path& path) {
    try {
        const Imf::InputFile file(path.c_str());
        if (!file.isComplete()) throw std::runtime_error("the file is not whole");
        ImageText text;
        const Imf::Header& header = file.header();
        for (auto a = header.begin(); a != header.end(); ++a) {
            const auto* value = dynamic_cast<const Imf::StringAttribute*>(&a.attribute());
            if (value != nullptr) text.emplace_back(a.name(), value->value());
        }
        return text;
    } catch (const std::exception& e) {
        fail(path, e.what());
    }
}

FloatImage read_exr(const std::filesystem::path& path) {
    try {
        Imf::InputFile file(path.c_str());
        const Imath::Box2i window = file.header().dataWindow();
        FloatImage image{window.max.x - window.min.x + 1, window.max.y - window.min.y + 1, {}};
        const auto count =
            static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
        const Imf::ChannelList& channels = file.header().channels();
        for (auto c = channels.begin(); c != channels.end(); ++c)
            image.channels.emplace_back(c.name(), std::vector<float>(count));
        Imf::FrameBuffer pixels;
        for (auto& [channel, values] : image.channels)
            pixels.insert(channel, slice(Imf::FLOAT, values.data(), sizeof(float), image.width));
        file.setFrameBuffer(pixels);
        file.readPixels(window.min.y, window.max.y);
        return image;
    } catch (const std::exception& e) {
        fail(path, e.what());
    }
}
#else
bool exr_available() {
    return false;
}

void write_exr(const std::filesystem::path& path, const FloatImage&, const ImageText&) {
    throw std::runtime_error(path.string() + ": this program was built without OpenEXR");
}

ImageText read_exr_text(const std::filesystem::path& path) {
    throw std::runtime_error(path.string() + ": this program was built without OpenEXR");
}

FloatImage read_exr(const std::filesystem::path& path) {
    throw std::runtime_error(path.string() + ": this program was built without OpenEXR");
}
#endif

}  // namespace ember
