// Contexts without a window.
#include <gtest/gtest.h>

#include "render/image_difference.h"
#include "support/gl_rig.h"

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

namespace ember {
namespace {

TEST(OffscreenContext, OsMesaGivesACoreProfileOnThePinnedRasteriser) {
    const auto context = test::pinned_context(GlBackend::OsMesa);
    EXPECT_EQ(context->name(), "osmesa");
    const Renderer renderer(context->loader());
    EXPECT_NE(renderer.description().find("llvmpipe"), std::string::npos) << renderer.description();
    EXPECT_NE(renderer.description().find("128 bits"), std::string::npos) << renderer.description();
    EXPECT_NE(renderer.description().find("Core Profile"), std::string::npos)
        << renderer.description();
}

TEST(OffscreenContext, SurfacelessEglDrawsThePictureThatOsMesaDraws) {
#ifdef __SANITIZE_ADDRESS__
    // Mesa's EGL leaks, and is gone when the sanitizer looks, so that it cannot be named in
    // tests/checks/leaks_of_others.txt
    const __lsan::ScopedDisabler unwatched;
#endif
    const test::StagedWorld staged = test::burning_sheet(16, 24, 200);
    const auto draw = [&](GlBackend backend, std::string_view name) {
        const auto context = test::pinned_context(backend);
        EXPECT_EQ(context->name(), name);
        const WorldView world = staged.view();
        return Renderer(context->loader()).draw_image({&world, {}}, {}, 160, 90);
    };
    const Image osmesa = draw(GlBackend::OsMesa, "osmesa"), egl = draw(GlBackend::Egl, "egl");
    const ImageDifference difference = compare(osmesa, egl);
    // two builds of Mesa may round differently, but they must not draw something else
    EXPECT_TRUE(difference.comparable);
    EXPECT_LE(difference.max_difference, 2);
}

TEST(OffscreenContext, AutoFindsOneOfThem) {
    EXPECT_EQ(test::pinned_context(GlBackend::Auto)->name(), "osmesa");
}

TEST(Renderer, ALoaderThatFindsNothingIsAnErrorAndNoCrash) {
    const GlLoader nothing = [](const char*) -> void (*)() { return nullptr; };
    EXPECT_THROW(Renderer{nothing}, RenderError);
}

}  // namespace
}  // namespace ember
