// The passes of a frame, in the order in which they run. A pass whose input is empty is not run.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <vector>

#include "render/camera.h"
#include "render/fire_sprites.h"
#include "render/flame_lights.h"
#include "render/gl_objects.h"
#include "render/legend.h"
#include "render/lighting.h"
#include "render/palette.h"
#include "render/renderer.h"
#include "render/shader_library.h"
#include "render/sheet_vertices.h"
#include "render/stage_bounds.h"

namespace ember {

/// What every pass may look at.
struct PassInput {
    const Frame& frame;
    const RenderParams& params;
    const Camera& camera;
    const FireCells& fire;
    const FlameLights& lights;
    const Lighting& lighting;
    const Bounds& bounds;                      ///< of the paper
    const Eigen::Matrix4f& shadow_from_world;  ///< to 0 .. 1 in the shadow map
    const Texture& shadow;                     ///< of nothing where there is none
    bool paper;                                ///< whether there are sheets to draw
    int width, height;
};

/// What is behind everything: the backdrop, and before it the floor with the shadow of the paper
/// and the light of the flames on it. All of it is soft, so half the pixels each way do.
class BackgroundPass {
  public:
    BackgroundPass();
    void draw(const PassInput& in, bool ground);
    [[nodiscard]] const Texture& texture() const { return colour_; }

  private:
    void draw_ground(const PassInput& in);
    Program backdrop_{"screen", "backdrop"}, ground_{"ground"};
    Texture colour_;
    Framebuffer target_;
    VertexArray array_, empty_;
    Buffer vertices_, indices_;
    GLsizei count_ = 0;
    int width_ = 0, height_ = 0;
};

/// The nozzles of all lighters that burn.
class LighterPass {
  public:
    void draw(const PassInput& in);

  private:
    Program program_{"solid"};
    VertexArray array_;
    Buffer vertices_;
    std::vector<Vector3> uploaded_;  ///< [m] where the buffer has them
    GLsizei count_ = 0;
};

/// What shaders/sheet.frag draws: the picture, or an ingredient of it. Data: distance [m],
/// temperature [degC], phase.
enum class PaperLayer { Picture, Albedo, Emission, Normal, Data };

/// The sheets as lit quads, or coloured by a quantity.
class SheetPass {
  public:
    explicit SheetPass(int samples);
    /// Brings the buffers up to date for a picture `height` pixels high; whether there is anything
    /// to draw.
    [[nodiscard]] bool prepare(const Frame& frame, const RenderParams& params, int height);
    void draw(const PassInput& in);
    /// Draws what the paper is made of, for compositing, instead of how it looks.
    void draw_layer(const PassInput& in, PaperLayer layer);
    /// Draws the triangles with the program in use, without thickness; attribute 0 is the position.
    void draw_triangles() const;
    [[nodiscard]] int uploads() const { return uploads_; }  ///< how often data went to buffers

  private:
    void upload_topology(const WorldView& world, double pixels_per_metre, double ragged);
    void bind_paper(const PassInput& in, PaperLayer layer);
    void draw_thick();
    void draw_paper(const PassInput& in);
    void draw_quantity(const PassInput& in);
    // What is printed on a face, as a texture that is made anew when the picture is another one.
    struct Print {
        std::shared_ptr<const PictureFile> picture;
        Texture ink;
        explicit Print() { show(nullptr); }
        void show(const std::shared_ptr<const PictureFile>& wanted);
    };
    int samples_;
    Program paper_{"sheet"}, quantity_{"sheet", "quantity"};
    // Noise of the paper. Near the camera it needs more than 8 bits between the texels.
    struct Noise {
        Texture fibre, crackle;
        explicit Noise(GLenum internal_format);
    };
    Texture scorch_, ember_, heat_, mass_, stress_;
    Noise noise_{GL_RGBA8};
    std::unique_ptr<const Noise> near_noise_;  ///< made when it is first needed
    bool near_ = false;
    Print front_, back_;
    VertexArray array_;
    Buffer vertices_, points_, indices_;
    std::vector<SheetVertex> packed_, fresh_;  ///< what the buffer holds, and of this picture
    int uploads_ = 0;
    std::vector<std::uint64_t> uploaded_;  ///< topology that points and indices hold
    int level_ = 1;                        ///< of the patches
    double ragged_ = 0;                    ///< [cells] of their edges
    int shells_ = 1;                       ///< see shell_count()
    float caliper_ = 0;                    ///< [m] from the first to the last of them
    GLsizei index_count_ = 0;
};

/// What the studio lamp sees of the paper, blurred, so that shadows are soft.
class ShadowPass {
  public:
    ShadowPass();
    /// Draws `sheets`, which must be prepared. Leaves the map in texture().
    void draw(const PassInput& in, const SheetPass& sheets, int size);
    [[nodiscard]] const Texture& texture() const { return map_; }
    [[nodiscard]] const Texture& none() const { return none_; }  ///< no shadow anywhere

  private:
    Program program_{"shadow"}, blur_{"screen", "blur"};
    VertexArray empty_;
    Texture map_, spare_, none_;
    Renderbuffer depth_;
    Framebuffer target_, spare_target_;
    int size_ = 0;
};

/// Springs as lines, by kind (figures 4 and 6 of the paper) or by stiffness (figure 3).
class LatticePass {
  public:
    LatticePass();
    [[nodiscard]] bool draw(const PassInput& in);  ///< whether there was anything to draw

  private:
    Program program_{"lines"};
    VertexArray array_;
    Buffer vertices_;
};

/// What the colours of a view mean, over the developed picture.
class LegendPass {
  public:
    LegendPass();
    /// Draws into framebuffer `target`.
    void draw(const PassInput& in, const Legend& legend, unsigned target);

  private:
    Program program_{"legend"};
    Texture font_;
    VertexArray array_;
    Buffer vertices_;
};

/// Flames, smoke and sparks, into a buffer of their own with fewer pixels.
class FirePass {
  public:
    FirePass();
    /// Brings the sprites up to date; whether any is in the picture.
    [[nodiscard]] bool prepare(const PassInput& in);
    [[nodiscard]] int uploads() const { return uploads_; }  ///< how often data went to buffers
    /// `depth` is the resolved depth of the scene. Leaves premultiplied light in texture().
    void draw(const PassInput& in, const Texture& depth);
    [[nodiscard]] const Texture& texture() const { return colour_; }
    /// How much flame (red) and smoke (alpha) is in the line of sight, as optical depths.
    [[nodiscard]] const Texture& amounts() const { return amounts_; }

  private:
    void bind_inputs(const Program& program, const PassInput& in, const Texture& depth);
    void draw_sprites(GLsizei first, GLsizei count);
    Program program_{"fire"}, light_{"screen", "flame"}, spark_{"fire", "spark"};
    Texture amounts_, colour_, ramp_, sprites_;
    Framebuffer amounts_target_, target_;
    VertexArray array_, empty_;
    Buffer instances_;
    std::vector<FireSprite> packed_;  ///< what the buffer holds
    int uploads_ = 0;
    GLsizei flames_ = 0, sparks_ = 0;
    int width_ = 0, height_ = 0;
};

/// What the film gets.
struct FilmInput {
    const Texture* background = nullptr;  ///< null: nothing, the picture is transparent
    const Texture* fire = nullptr;        ///< null: no fire
    bool haze = false;                    ///< whether haze() has bent the scene's light
    bool bloom = false;                   ///< whether anything can be too bright for the film
    bool linear = false;                  ///< light as it is, rather than developed
    unsigned target = 0;                  ///< framebuffer
};

/// The scene buffers, and the film: bloom, tone mapping, sRGB.
class FilmPass {
  public:
    /// Binds and clears the multisampled buffers, to transparent black.
    void begin(int width, int height, int samples);
    void resolve(bool depth);  ///< to one sample per pixel; without the depth it holds nothing
    [[nodiscard]] const Texture& depth() const { return depth_; }
    /// Bends the scene's light. Only before develop() with haze. `gas`: FirePass::amounts().
    void haze(const PassInput& in, const Texture& gas);
    /// Spreads what is too bright. Only before develop() with bloom.
    void bloom(const PassInput& in, const FilmInput& film);
    /// Develops the scene and the fire.
    void develop(const PassInput& in, const FilmInput& film);

  private:
    void allocate_buffers(int width, int height);
    void bind_inputs(const Program& program, const PassInput& in, const FilmInput& film);
    int samples_ = 0, width_ = 0, height_ = 0;
    int hazy_width_ = 0, hazy_height_ = 0;
    Program haze_{"screen", "haze"}, bright_{"screen", "bright"}, blur_{"screen", "blur"},
        film_{"screen", "film"};
    VertexArray empty_;
    Renderbuffer multi_colour_, multi_depth_;
    Texture colour_, depth_, hazy_, bloom_, spare_;
    Framebuffer multi_, single_, hazy_target_, bloom_target_, spare_target_;
};

/// Renderer::draw_layers: light and its ingredients in floating point.
class LayerPass {
  public:
    void begin(int width, int height);  ///< the next frame is wanted as layers
    [[nodiscard]] bool wanted() const { return wanted_; }
    [[nodiscard]] unsigned target() const { return target_.name(); }  ///< for the light
    void draw_paper(const PassInput& in, SheetPass& sheets);          ///< after the light
    [[nodiscard]] FloatImage take();

  private:
    void read(std::initializer_list<const char*> names);
    Texture colour_;
    Renderbuffer depth_;
    Framebuffer target_;
    FloatImage image_;
    bool wanted_ = false, paper_ = false;
};

/// Uploads a colour table as a 1-pixel-high texture.
[[nodiscard]] Texture table_texture(Colour (*function)(double), double end);

/// Sets camera, lights, shadow map and view position for a lit program.
void set_lighting(const Program& program, const PassInput& in);

}  // namespace ember
