#include <cstddef>
#include <utility>

#include "render/passes.h"

namespace ember {
namespace {

constexpr float kFar = 1.0e10f;  // [m] depth where there is nothing

}  // namespace

void LayerPass::begin(int width, int height) {
    image_ = {width, height, {}};
    wanted_ = true;
    paper_ = false;
    allocate(colour_, GL_RGBA32F, GL_RGBA, GL_FLOAT, width, height);
    glBindRenderbuffer(GL_RENDERBUFFER, depth_.name());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, target_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_.name(), 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
}

// Adds the buffer's channels under `names`, from red on.
void LayerPass::read(std::initializer_list<const char*> names) {
    const auto width = static_cast<std::size_t>(image_.width);
    const auto height = static_cast<std::size_t>(image_.height);
    std::vector<float> pixels(width * height * 4);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, target_.name());
    glReadPixels(0, 0, image_.width, image_.height, GL_RGBA, GL_FLOAT, pixels.data());
    std::size_t channel = 0;
    for (const char* name : names) {
        std::vector<float> values;
        values.reserve(width * height);
        for (std::size_t y = height; y-- > 0;) {
            for (std::size_t x = 0; x < width; ++x)
                values.push_back(pixels[4 * (y * width + x) + channel]);
        }
        image_.channels.emplace_back(name, std::move(values));
        ++channel;
    }
}

void LayerPass::draw_paper(const PassInput& in, SheetPass& sheets) {
    read({"R", "G", "B", "A"});
    paper_ = true;
    const auto draw = [&](PaperLayer layer, const Eigen::Vector4f& nothing,
                          std::initializer_list<const char*> names) {
        glBindFramebuffer(GL_FRAMEBUFFER, target_.name());
        glViewport(0, 0, in.width, in.height);
        glClearColor(nothing.x(), nothing.y(), nothing.z(), nothing.w());
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        sheets.draw_layer(in, layer);
        read(names);
    };
    glEnable(GL_DEPTH_TEST);
    const Eigen::Vector4f black = Eigen::Vector4f::Zero();
    draw(PaperLayer::Albedo, black, {"albedo.R", "albedo.G", "albedo.B"});
    draw(PaperLayer::Emission, black, {"emission.R", "emission.G", "emission.B"});
    draw(PaperLayer::Normal, black, {"normal.X", "normal.Y", "normal.Z"});
    draw(PaperLayer::Data, {kFar, 0.0f, -1.0f, 0.0f}, {"depth.Z", "temperature.T", "phase.id"});
}

FloatImage LayerPass::take() {
    if (!paper_) read({"R", "G", "B", "A"});
    wanted_ = false;
    return std::exchange(image_, {});
}

}  // namespace ember
