#include "ui/kept_picture.h"

#include <algorithm>

namespace ember {
namespace {

bool same(const RenderParams& a, const RenderParams& b) {
    return std::ranges::all_of(
        render_param_rows(), [&](const ParamInfo& row) { return row.value(&a) == row.value(&b); });
}

}  // namespace

bool KeptPicture::holds(const PictureKey& key) {
    const bool fits = key.width == key_.width && key.height == key_.height;
    const bool current = key.revision == key_.revision && key.beside == key_.beside;
    if (fits && current && same(key.render, key_.render)) return true;
    if (!fits) {
        allocate(colour_, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, key.width, key.height);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_.name(),
                               0);
    }
    key_ = key;
    return false;
}

void KeptPicture::show(int x, int y, unsigned target) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target);
    glBlitFramebuffer(0, 0, key_.width, key_.height, x, y, x + key_.width, y + key_.height,
                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

}  // namespace ember
