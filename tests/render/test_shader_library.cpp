// GLSL programs and the files embedded in the binary.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "render/assets.h"
#include "render/shader_library.h"
#include "support/gl_rig.h"

namespace ember {
namespace {

constexpr const char* kVertex = "void main() {\n    gl_Position = vec4(0.0);\n}\n";
constexpr const char* kFragment =
    "out vec4 o_colour;\nvoid main() {\n    o_colour = vec4(1.0);\n}\n";

std::string error_of(const std::string& vertex, const std::string& fragment) {
    try {
        const Program program("good.vert", vertex, "bad.frag", fragment);
    } catch (const RenderError& e) {
        return e.what();
    }
    return "no error";
}

TEST(ShaderLibrary, AShaderThatDoesNotCompileNamesItsFileAndLine) {
    const test::GlRig rig;
    EXPECT_EQ(error_of(kVertex, kFragment), "no error");
    const std::string error =
        error_of(kVertex, "out vec4 o_colour;\n\nvoid main() {\n    o_colour = vec4(nonsense);\n}");
    EXPECT_EQ(error.find("bad.frag:4: "), 0u) << error;
    EXPECT_NE(error.find("nonsense"), std::string::npos) << error;
    EXPECT_EQ(error_of("void main() {\n    oops;\n}", kFragment).find("good.vert:2: "), 0u);
}

TEST(ShaderLibrary, EveryDriversPlacesAreUnderstood) {
    EXPECT_EQ(located("a.frag", "0:12(5): error: no such name"), "a.frag:12: error: no such name");
    EXPECT_EQ(located("a.frag", "0(12) : error C1503: undefined variable"),
              "a.frag:12: error C1503: undefined variable");
    EXPECT_EQ(located("a.frag", "ERROR: 0:12: 'b' : undeclared"),
              "a.frag:12: error: 'b' : undeclared");
    EXPECT_EQ(located("a.frag", "out of memory"), "a.frag: out of memory");
}

TEST(ShaderLibrary, ShadersThatDoNotFitTogetherNameBothFiles) {
    const test::GlRig rig;
    const std::string error =
        error_of("out vec2 v_a;\nvoid main() {\n    gl_Position = vec4(v_a = vec2(0), 0, 0);\n}",
                 "in vec3 v_a;\nout vec4 o_colour;\nvoid main() {\n    o_colour = v_a.xyzz;\n}");
    EXPECT_NE(error.find("good.vert"), std::string::npos) << error;
    EXPECT_NE(error.find("bad.frag"), std::string::npos) << error;
}

TEST(ShaderLibrary, AMissingFileIsNamed) {
    const test::GlRig rig;
    try {
        const Program program("no_such");
        FAIL() << "compiled";
    } catch (const RenderError& e) {
        EXPECT_NE(std::string(e.what()).find("no_such."), std::string::npos) << e.what();
    }
}

TEST(ShaderLibrary, ABadShaderInAFolderNamesItsLineAndTheLastGoodOnesGoOnRunning) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::temp_directory_path() / "emberleaf_shaders";
    fs::create_directories(folder);
    const auto write = [&](const char* text) { std::ofstream(folder / "film.frag") << text; };
    test::GlRig rig;
    const test::StagedWorld staged = test::hanging_sheet(4, 6);
    const Image before = rig.draw(staged.view(), {});
    write("out vec4 o_colour;\n\nvoid main() {\n    o_colour = vec4(nonsense);\n}\n");
    try {
        rig.renderer.reload(folder);
        ADD_FAILURE() << "compiled";
    } catch (const RenderError& e) {
        EXPECT_EQ(std::string(e.what()).find("film.frag:4: "), 0u) << e.what();
    }
    EXPECT_EQ(rig.draw(staged.view(), {}).rgba, before.rgba);
    write("out vec4 o_colour;\nvoid main() { o_colour = vec4(0.0, 0.5, 0.0, 1.0); }\n");
    rig.renderer.reload(folder);
    EXPECT_NE(rig.draw(staged.view(), {}).rgba, before.rgba);
    fs::remove_all(folder);
    EXPECT_THROW(rig.renderer.reload(folder), RenderError) << "nothing there";
    rig.renderer.reload({});
    EXPECT_EQ(rig.draw(staged.view(), {}).rgba, before.rgba);
}

TEST(Assets, EveryShaderOpensBySayingWhatGoesInAndWhatComesOut) {
    int shaders = 0;
    for (const Asset& a : assets()) {
        if (!a.name.ends_with(".vert") && !a.name.ends_with(".frag")) continue;
        ++shaders;
        const std::string text(a.bytes.begin(), a.bytes.end());
        const std::string opening = text.substr(0, text.find("\n\n"));
        EXPECT_TRUE(opening.starts_with("// ")) << a.name;
        EXPECT_NE(opening.find("// out "), std::string::npos) << a.name;
    }
    EXPECT_GE(shaders, 10);
}

}  // namespace
}  // namespace ember
