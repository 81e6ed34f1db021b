#include "render/offscreen_context.h"

#include <dlfcn.h>

#define EGL_NO_X11  // EGL's headers would pull in X11, which is not needed without a surface
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/osmesa.h>

#include <cstdlib>
#include <cstring>
#include <vector>

namespace ember {
namespace {

constexpr const char* kSoftwareOnly = "LIBGL_ALWAYS_SOFTWARE";  // Mesa's own

// A shared library opened at run time.
class Library {
  public:
    explicit Library(const char* name) : handle_(dlopen(name, RTLD_NOW | RTLD_LOCAL)) {
        if (handle_ == nullptr) throw RenderError(dlerror());
    }
    // not closed: the rasteriser keeps threads and thread-local data until the program ends

    template <class Function>
    Function* find(const char* name) const {
        void* symbol = dlsym(handle_, name);
        if (symbol == nullptr) throw RenderError(dlerror());
        return reinterpret_cast<Function*>(symbol);
    }

  private:
    void* handle_;
};

class OsMesaContext final : public OffscreenContext {
  public:
    OsMesaContext() : library_("libOSMesa.so.8") {
        const int attributes[] = {OSMESA_FORMAT,
                                  OSMESA_RGBA,
                                  OSMESA_DEPTH_BITS,
                                  0,
                                  OSMESA_PROFILE,
                                  OSMESA_CORE_PROFILE,
                                  OSMESA_CONTEXT_MAJOR_VERSION,
                                  3,
                                  OSMESA_CONTEXT_MINOR_VERSION,
                                  3,
                                  0};
        const auto create =
            library_.find<OSMesaContext(const int*, OSMesaContext)>("OSMesaCreateContextAttribs");
        destroy_ = library_.find<void(OSMesaContext)>("OSMesaDestroyContext");
        loader_ = library_.find<OSMESAproc(const char*)>("OSMesaGetProcAddress");
        const auto make_current =
            library_.find<GLboolean(OSMesaContext, void*, GLenum, GLsizei, GLsizei)>(
                "OSMesaMakeCurrent");
        context_ = create(attributes, nullptr);
        if (context_ == nullptr) throw RenderError("no OpenGL 3.3 core context");
        // we draw into framebuffers of our own; the context's one is a single pixel
        pixel_.resize(4);
        if (make_current(context_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1) == GL_FALSE) {
            destroy_(context_);
            throw RenderError("the context cannot be made current");
        }
    }
    ~OsMesaContext() override { destroy_(context_); }
    OsMesaContext(const OsMesaContext&) = delete;
    OsMesaContext& operator=(const OsMesaContext&) = delete;

    [[nodiscard]] GlLoader loader() const override { return loader_; }
    [[nodiscard]] std::string_view name() const override { return "osmesa"; }

  private:
    Library library_;
    std::vector<unsigned char> pixel_;
    OSMesaContext context_ = nullptr;
    void (*destroy_)(OSMesaContext) = nullptr;
    OSMESAproc (*loader_)(const char*) = nullptr;
};

class EglContext final : public OffscreenContext {
  public:
    EglContext() : library_("libEGL.so.1") {
        loader_ = library_.find<__eglMustCastToProperFunctionPointerType(const char*)>(
            "eglGetProcAddress");
        make_current_ = library_.find<EGLBoolean(EGLDisplay, EGLSurface, EGLSurface, EGLContext)>(
            "eglMakeCurrent");
        for (EGLDeviceEXT card : graphics_cards()) {
            if (open(EGL_PLATFORM_DEVICE_EXT, card)) return;
        }
        if (!open(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY))
            throw RenderError("no graphics card and no surfaceless display with OpenGL 3.3 core");
    }
    ~EglContext() override {
        make_current_(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        library_.find<EGLBoolean(EGLDisplay, EGLContext)>("eglDestroyContext")(display_, context_);
        terminate();
    }
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

    [[nodiscard]] GlLoader loader() const override { return loader_; }
    [[nodiscard]] std::string_view name() const override { return "egl"; }

  private:
    template <class Function>
    [[nodiscard]] Function extension(const char* name) const {
        return reinterpret_cast<Function>(loader_(name));
    }

    // Devices that are hardware, unless Mesa is asked to do without. Some vendors' drivers know
    // these only, and no surfaceless display.
    [[nodiscard]] std::vector<EGLDeviceEXT> graphics_cards() const {
        const auto query_devices = extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
        const auto query_string =
            extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
        EGLint count = 0;
        if (std::getenv(kSoftwareOnly) != nullptr || query_devices == nullptr ||
            query_string == nullptr || query_devices(0, nullptr, &count) == EGL_FALSE || count <= 0)
            return {};
        std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
        if (query_devices(count, devices.data(), &count) == EGL_FALSE) return {};
        devices.resize(static_cast<std::size_t>(count));
        std::erase_if(devices, [&](EGLDeviceEXT device) {
            const char* extensions = query_string(device, EGL_EXTENSIONS);
            return extensions != nullptr && std::strstr(extensions, "EGL_MESA_device_software");
        });
        return devices;
    }

    // Makes a context of that display current; leaves nothing behind where it has none.
    [[nodiscard]] bool open(EGLenum platform, void* native) {
        const auto platform_display =
            extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
        if (platform_display == nullptr) throw RenderError("no platform displays");
        display_ = platform_display(platform, native, nullptr);
        const auto initialize =
            library_.find<EGLBoolean(EGLDisplay, EGLint*, EGLint*)>("eglInitialize");
        if (display_ == EGL_NO_DISPLAY || initialize(display_, nullptr, nullptr) == EGL_FALSE)
            return false;
        library_.find<EGLBoolean(EGLenum)>("eglBindAPI")(EGL_OPENGL_API);
        const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                     3,
                                     EGL_CONTEXT_MINOR_VERSION,
                                     3,
                                     EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                     EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                     EGL_NONE};
        const auto create =
            library_.find<EGLContext(EGLDisplay, EGLConfig, EGLContext, const EGLint*)>(
                "eglCreateContext");
        context_ = create(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
        if (context_ != EGL_NO_CONTEXT &&
            make_current_(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_FALSE)
            return true;
        terminate();
        return false;
    }
    void terminate() const { library_.find<EGLBoolean(EGLDisplay)>("eglTerminate")(display_); }

    Library library_;
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
    EGLBoolean (*make_current_)(EGLDisplay, EGLSurface, EGLSurface, EGLContext) = nullptr;
    __eglMustCastToProperFunctionPointerType (*loader_)(const char*) = nullptr;
};

}  // namespace

std::unique_ptr<OffscreenContext> OffscreenContext::create(GlBackend backend) {
    std::string reasons;
    if (backend != GlBackend::Egl) {
        try {
            return std::make_unique<OsMesaContext>();
        } catch (const RenderError& e) {
            reasons += std::string("OSMesa: ") + e.what();
        }
    }
    if (backend != GlBackend::OsMesa) {
        try {
            return std::make_unique<EglContext>();
        } catch (const RenderError& e) {
            reasons += std::string(reasons.empty() ? "" : "; ") + "EGL: " + e.what();
        }
    }
    throw RenderError("no off-screen OpenGL (" + reasons +
                      "); on Debian: sudo apt install libosmesa6 libegl1");
}

void pin_software_rasteriser() {
    ::setenv(kSoftwareOnly, "1", 1);
    ::setenv("GALLIUM_DRIVER", "llvmpipe", 1);
    ::setenv("GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1", 1);
}

}  // namespace ember
