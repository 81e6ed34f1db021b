// What of the fire is drawn where: particles as tongues of flame, glowing gas, smoke and sparks.
// Pure, no GL.
#pragma once

#include <vector>

#include "render/camera.h"
#include "render/fire_cells.h"

namespace ember {

/// A particle plays one part for all its life, chosen by its number.
enum class FirePart : std::uint8_t { None, Tongue, Base, Smoke, Spark };

/// A textured strip from `tail` to `head`, which turns about this axis to face the camera.
struct FireSprite {
    Eigen::Vector3f tail, head;  ///< [m]
    float half_width;            ///< [m]
    float row, frame;            ///< place in the flipbook; frames are blended
    float mirror;                ///< 1 or -1
    float heat;                  ///< [1] 1 at birth temperature, 0 at ambient
    float flame, blue, smoke;    ///< [1] how much of each this sprite adds where it is densest
};

/// Sprites of flames and smoke, then those of sparks.
struct FireSprites {
    std::vector<FireSprite> sprites;
    std::size_t flames = 0;  ///< the first so many are not sparks
};

/// How the fire looks.
struct FireLook {
    double size = 0.026;   ///< [m] width of a tongue
    double share = 0.055;  ///< [1] of the particles are tongues
    double smoke = 1.0;    ///< [1] opacity of smoke relative to our choice
    double sparks = 1.0;   ///< [1] number of sparks relative to our choice
};

/// The part that a particle plays: a pure function of its number.
[[nodiscard]] FirePart fire_part(std::uint64_t id, const FireLook& look);

/// Where among those of its part a particle comes, 0 to 1, as evenly: of a crowd only the first are
/// drawn.
[[nodiscard]] double fire_rank(std::uint64_t id, const FireLook& look);

/// All sprites that are at least partly in the picture. Each is a pure function of its particle's
/// number, age and flight and of how much fire is around it (`cells` of the same world), and fades
/// in and out, so that nothing pops.
[[nodiscard]] FireSprites gather_fire_sprites(const WorldView& world, const FireCells& cells,
                                              const FireLook& look, const Camera& camera);

}  // namespace ember
