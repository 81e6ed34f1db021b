#include "app/frame_painter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/units.h"

namespace ember {
namespace {

double to_linear(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

double to_encoded(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

std::uint8_t byte_of(double share) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
}

// Adds the light of `layers`, the channels R, G, B, A, to that of `sum`.
void add_light(FloatImage& sum, const FloatImage& layers) {
    for (std::size_t c = 0; c < 4 && c < sum.channels.size(); ++c) {
        std::vector<float>& to = sum.channels[c].second;
        const std::vector<float>& from = layers.channels[c].second;
        for (std::size_t i = 0; i < to.size(); ++i)
            to[i] += from[i];
    }
}

}  // namespace

Image mean_of(std::span<const Image> images) {
    static const std::array<double, 256> linear = [] {
        std::array<double, 256> table{};
        for (std::size_t i = 0; i < table.size(); ++i)
            table[i] = to_linear(static_cast<double>(i) / 255);
        return table;
    }();
    Image mean = images.front();
    if (images.size() == 1) return mean;
    for (std::size_t p = 0; p < mean.rgba.size(); p += 4) {
        std::array<double, 3> light{};
        double covered = 0;
        for (const Image& image : images) {
            const double alpha = image.rgba[p + 3];
            covered += alpha;
            for (std::size_t c = 0; c < 3; ++c)
                light[c] += alpha * linear[image.rgba[p + c]];
        }
        for (std::size_t c = 0; c < 3; ++c)
            mean.rgba[p + c] = covered > 0 ? byte_of(to_encoded(light[c] / covered)) : 0;
        mean.rgba[p + 3] = byte_of(covered / 255 / static_cast<double>(images.size()));
    }
    return mean;
}

RenderParams look_at(const RenderJob& job, double turntable, double clock) {
    RenderParams look = job.preset.render;
    job.keys.apply(look, clock);
    look.camera.azimuth +=
        unit::degree.to_si(turntable) * clock / std::max(look.shot.duration, 1e-9);
    return look;
}

FramePainter::FramePainter(const RenderOptions& options)
    : options_(options),
      context_(OffscreenContext::create(options.gl)),
      renderer_(context_->loader(), options.msaa) {
    if (!options.shaders.empty()) renderer_.reload(options.shaders);
}

Picture FramePainter::paint(const RenderJob& job, const PlannedPicture& planned,
                            std::span<const FrameView> samples, bool image, bool layers) {
    Picture picture{{}, {}, planned.number, planned.time};
    const int width = job.size.width, height = job.size.height;
    std::vector<Image> images;
    for (const FrameView& sample : samples) {
        const double late = planned.exposure > 0 ? sample.view.time - planned.time : 0;
        const RenderParams look = look_at(job, options_.turntable, planned.clock + late);
        const Frame shown{&sample.view, sample.springs};
        if (image) images.push_back(renderer_.draw_image(shown, look, width, height));
        if (!layers) continue;
        FloatImage drawn = renderer_.draw_layers(shown, look, width, height);
        if (picture.layers.channels.empty()) {
            picture.layers = std::move(drawn);
        } else {
            add_light(picture.layers, drawn);
        }
    }
    if (image) picture.image = mean_of(images);
    for (std::size_t c = 0; samples.size() > 1 && c < 4 && layers; ++c) {
        for (float& value : picture.layers.channels[c].second)
            value /= static_cast<float>(samples.size());
    }
    return picture;
}

}  // namespace ember
