#include "ui/imgui_painter.h"

#include <algorithm>
#include <cstddef>

namespace ember {

ImguiPainter::ImguiPainter() {
    ImGuiIO& io = ImGui::GetIO();
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    allocate(font_, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, width, height);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    io.Fonts->SetTexID(reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(font_.name())));
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    glBindVertexArray(array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    float_attribute(0, 2, sizeof(ImDrawVert), offsetof(ImDrawVert, pos));
    float_attribute(1, 2, sizeof(ImDrawVert), offsetof(ImDrawVert, uv));
    glEnableVertexAttribArray(2);
    glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(ImDrawVert),
                          reinterpret_cast<const void*>(offsetof(ImDrawVert, col)));
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
    glBindVertexArray(0);
}

void ImguiPainter::draw(const ImDrawData& data, unsigned target) {
    const float scale_x = data.FramebufferScale.x, scale_y = data.FramebufferScale.y;
    const int width = static_cast<int>(data.DisplaySize.x * scale_x);
    const int height = static_cast<int>(data.DisplaySize.y * scale_y);
    if (width <= 0 || height <= 0) return;
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glViewport(0, 0, width, height);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_SCISSOR_TEST);
    program_.use();
    program_.set("u_font", 0);
    program_.set("u_origin", Eigen::Vector2f(data.DisplayPos.x, data.DisplayPos.y));
    program_.set("u_size", Eigen::Vector2f(data.DisplaySize.x, data.DisplaySize.y));
    glBindVertexArray(array_.name());
    for (int n = 0; n < data.CmdListsCount; ++n) {
        const ImDrawList& list = *data.CmdLists[n];
        const auto vertex_count = static_cast<std::size_t>(list.VtxBuffer.Size);
        const auto index_count = static_cast<std::size_t>(list.IdxBuffer.Size);
        upload<ImDrawVert>(GL_ARRAY_BUFFER, vertices_, {list.VtxBuffer.Data, vertex_count});
        upload<ImDrawIdx>(GL_ELEMENT_ARRAY_BUFFER, indices_, {list.IdxBuffer.Data, index_count});
        for (const ImDrawCmd& command : list.CmdBuffer) {
            if (command.UserCallback != nullptr) continue;
            const float x0 = (command.ClipRect.x - data.DisplayPos.x) * scale_x;
            const float y0 = (command.ClipRect.y - data.DisplayPos.y) * scale_y;
            const float x1 = (command.ClipRect.z - data.DisplayPos.x) * scale_x;
            const float y1 = (command.ClipRect.w - data.DisplayPos.y) * scale_y;
            if (x1 <= x0 || y1 <= y0) continue;
            glScissor(static_cast<GLint>(x0), height - static_cast<GLint>(y1),
                      static_cast<GLsizei>(x1 - x0), static_cast<GLsizei>(y1 - y0));
            glActiveTexture(GL_TEXTURE0);
            glBindTexture(GL_TEXTURE_2D,
                          static_cast<GLuint>(reinterpret_cast<std::intptr_t>(command.GetTexID())));
            const std::size_t offset = command.IdxOffset * sizeof(ImDrawIdx);
            glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount),
                                     sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
                                     reinterpret_cast<const void*>(offset),
                                     static_cast<GLint>(command.VtxOffset));
        }
    }
    glBindVertexArray(0);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
}

}  // namespace ember
