#include "render/fire_sprites.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace ember {
namespace {

constexpr int kTongueRows = 4;  // of the flipbook, textures/make_flames.cpp
constexpr double kFrames = 16;  // in a row
constexpr float kSoftRow = 4;   // its first cell is a spot, the others are smoke
constexpr double kBaseShare = 0.06, kSmokeShare = 0.030, kSparkShare = 0.002;
constexpr double kBaseLife = 0.17;  // [s] gas just above the paper
// Of more particles than this no more are drawn: they would only blur each other, and cost as much.
constexpr double kCrowd = 4000;
constexpr double kWidestView =
    0.6;  // [1] a sprite fills at most this share of the picture's height

double smooth(double from, double to, double x) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

// Random number in [0, 1) of a particle; lane tells several of the same particle apart.
double random_of(std::uint64_t id, std::uint64_t lane) {
    std::uint64_t h = (id + lane) * 0x9E3779B97F4A7C15ull;
    h ^= h >> 32;
    h *= 0xD6E8FEB86659FD93ull;
    h ^= h >> 32;
    return static_cast<double>(h >> 11) * 0x1p-53;
}

// A particle as the sprites see it.
struct Flying {
    Eigen::Vector3d at, velocity;  // [m], [m/s]
    double age, life, heat;        // [s], [1], [1]
    double gas;                    // [particles] around it, FireCells::gas_at()
    std::uint64_t id;
};

// Share of their lives for which particles are seen as flames where so many are. Small fires have
// low flames: their height grows with the heat that they release to the power of 1, if the gas is
// calm, to 2/5, if it is turbulent (G. Heskestad, Fire Safety Journal 5, 1983); between both, 1/2.
double flame_height(double gas) {
    constexpr double kFull = 240, kLowest = 0.4;
    return std::clamp(std::sqrt(gas / kFull), kLowest, 1.0);
}

FireSprite tongue(const Flying& p, const FireLook& look) {
    const double life = std::min(p.life / flame_height(p.gas), 1.0);
    const double kind = random_of(p.id, 1), length = random_of(p.id, 2), width = random_of(p.id, 3);
    const double speed = p.velocity.norm();
    // from where it was born to where it is while it grows; later it has come off the paper
    const double size = look.size * (0.7 + 0.6 * width);
    const double reach =
        std::min(0.25 * size + 0.55 * speed * p.age, look.size * (3.2 + 2.6 * length));
    // sideways drift would lay short flames flat; gas rises
    const Eigen::Vector3d axis =
        Eigen::Vector3d(0.5 * p.velocity.x(), std::max(p.velocity.y(), 0.0) + 0.10,
                        0.5 * p.velocity.z())
            .normalized();
    const double glows = smooth(0.03, 0.18, p.heat);
    const double fade = glows * smooth(0.0, 0.35, life) * (1.0 - smooth(0.70, 1.0, life));
    FireSprite s;
    s.tail = (p.at - 0.80 * reach * axis).cast<float>();
    s.head = (p.at + 0.45 * reach * axis).cast<float>();
    s.half_width = static_cast<float>(size * (0.36 + 0.34 * smooth(0.0, 0.3, life)));
    s.row = static_cast<float>(std::min(kTongueRows - 1, static_cast<int>(kind * kTongueRows)));
    s.frame = static_cast<float>((kFrames - 1.01) * life);
    s.mirror = random_of(p.id, 4) < 0.5 ? -1.0f : 1.0f;
    s.heat = static_cast<float>(0.35 + 0.65 * p.heat);
    s.flame = static_cast<float>(fade);
    s.blue = static_cast<float>(0.8 * glows * smooth(0.0, 0.06, life) *
                                (1.0 - smooth(0.10, 0.40, life)));
    s.smoke = 0;
    return s;
}

FireSprite soft_spot(const Flying& p, double radius, double stretch) {
    const double speed = p.velocity.norm();
    const Eigen::Vector3d axis =
        speed > 1e-6 ? Eigen::Vector3d(p.velocity / speed) : Eigen::Vector3d::UnitY();
    FireSprite s;
    s.tail = (p.at - radius * stretch * axis).cast<float>();
    s.head = (p.at + radius * stretch * axis).cast<float>();
    s.half_width = static_cast<float>(radius);
    s.row = kSoftRow;
    s.frame = 0;
    s.mirror = 1;
    s.heat = static_cast<float>(p.heat);
    s.flame = s.blue = s.smoke = 0;
    return s;
}

FireSprite base(const Flying& p, const FireLook& look) {
    FireSprite s = soft_spot(p, look.size * (0.16 + 0.20 * random_of(p.id, 1)), 2.2);
    const double fade = smooth(0.03, 0.18, p.heat) * smooth(0.0, 0.02, p.age) *
                        (1.0 - smooth(0.05, kBaseLife, p.age));
    s.flame = static_cast<float>(0.10 * fade);
    s.blue = static_cast<float>(0.4 * fade);
    return s;
}

FireSprite smoke(const Flying& p, const FireLook& look) {
    const double flame = flame_height(p.gas);  // begins where that ends
    FireSprite s =
        soft_spot(p, look.size * (0.5 + 1.5 * p.life) * (0.8 + 0.6 * random_of(p.id, 1)), 1.2);
    s.frame = static_cast<float>(1.0 + (kFrames - 2.01) * random_of(p.id, 2));
    s.mirror = random_of(p.id, 3) < 0.5 ? -1.0f : 1.0f;
    s.smoke = static_cast<float>(0.22 * look.smoke * smooth(0.40 * flame, 0.65 * flame, p.life) *
                                 (1.0 - smooth(0.70, 1.0, p.life)));
    return s;
}

// A spark has left its particle: it is thrown out, and falls behind as it slows down.
FireSprite spark(const Flying& p) {
    const double angle = 6.283185307179586 * random_of(p.id, 1);
    const double out = 0.25 + 0.5 * random_of(p.id, 2), up = 0.9 * random_of(p.id, 3) - 0.1;
    const Eigen::Vector3d thrown(out * std::cos(angle), up, out * std::sin(angle));
    constexpr double kFall = 2.2;  // [m/s^2]
    Flying moved = p;
    moved.at += p.age * thrown - 0.5 * kFall * p.age * p.age * Eigen::Vector3d::UnitY();
    moved.velocity += thrown - kFall * p.age * Eigen::Vector3d::UnitY();
    constexpr double kRadius = 0.0006, kExposure = 0.008;  // [m], [s] the shutter's
    const double streak = 1.0 + 0.5 * kExposure * moved.velocity.norm() / kRadius;
    FireSprite s = soft_spot(moved, kRadius, streak);
    const double twinkle = 0.75 + 0.25 * std::sin(40.0 * p.age + 6.28 * random_of(p.id, 4));
    s.flame =
        static_cast<float>(twinkle * smooth(0.0, 0.08, p.life) * (1.0 - smooth(0.55, 1.0, p.life)));
    return s;
}

// Whether the sprite is at least partly in the picture, and not in the lens, where it would hide
// all.
bool seen(const FireSprite& s, const Camera& camera) {
    const Eigen::Vector3f middle = 0.5f * (s.tail + s.head);
    const float depth = -(camera.view * middle.homogeneous()).z();
    return depth > 0.02f && sees(camera, middle, 0.5f * (s.head - s.tail).norm() + s.half_width);
}

// What a sprite costs is its area, so one that comes close to the camera stops growing.
void limit_size(FireSprite& s, const Camera& camera) {
    const Eigen::Vector3f middle = 0.5f * (s.tail + s.head);
    const float depth = -(camera.view * middle.homogeneous()).z();
    const float most = static_cast<float>(kWidestView) * camera.tan_half_fov * depth;
    const float half_length = 0.5f * (s.head - s.tail).norm();
    s.half_width = std::min(s.half_width, most);
    if (half_length <= most) return;
    const Eigen::Vector3f half = 0.5f * (s.head - s.tail) * (most / half_length);
    s.tail = middle - half;
    s.head = middle + half;
}

// A part, and where in that part's share a particle is, 0 .. 1.
struct Role {
    FirePart part;
    double rank;
};

Role role_of(std::uint64_t id, const FireLook& look) {
    double at = random_of(id, 0);
    const std::pair<FirePart, double> parts[] = {{FirePart::Tongue, look.share},
                                                 {FirePart::Base, kBaseShare},
                                                 {FirePart::Smoke, kSmokeShare},
                                                 {FirePart::Spark, kSparkShare * look.sparks}};
    for (const auto& [part, share] : parts) {
        if (at < share) return {part, at / share};
        at -= share;
    }
    return {FirePart::None, 0};
}

// How much of a particle is drawn where there are so many: of a crowd those of low rank, the last
// of them faintly, so that none comes or goes at once when the crowd changes.
float drawn_share(const Role& role, std::size_t particles) {
    const double keep = kCrowd / std::max(1.0, static_cast<double>(particles));
    return static_cast<float>(1.0 - smooth(keep, 1.4 * keep, role.rank));
}

}  // namespace

FirePart fire_part(std::uint64_t id, const FireLook& look) {
    return role_of(id, look).part;
}

double fire_rank(std::uint64_t id, const FireLook& look) {
    return role_of(id, look).rank;
}

FireSprites gather_fire_sprites(const WorldView& world, const FireCells& cells,
                                const FireLook& look, const Camera& camera) {
    FireSprites out;
    std::vector<FireSprite> sparks;
    const ParticleView& v = world.particles;
    float share = 1;  // of a sprite that is drawn
    const auto add = [&](FireSprite sprite, std::vector<FireSprite>& list) {
        sprite.flame *= share, sprite.blue *= share, sprite.smoke *= share;
        if (!(sprite.flame + sprite.blue + sprite.smoke > 1e-4f) || !seen(sprite, camera)) return;
        limit_size(sprite, camera);
        list.push_back(sprite);
    };
    for (std::size_t i = 0; i < v.x.size(); ++i) {
        const Role role = role_of(v.id[i], look);
        if (role.part == FirePart::None) continue;
        const FirePart part = role.part;
        share = drawn_share(role, v.x.size());
        if (share <= 0) continue;
        const Flying p{{v.x[i], v.y[i], v.z[i]},
                       {v.vx[i], v.vy[i], v.vz[i]},
                       world.time - v.birth[i],
                       particle_life(world, i),
                       particle_heat(world, i),
                       cells.gas_at({v.x[i], v.y[i], v.z[i]}),
                       v.id[i]};
        if (part == FirePart::Tongue) add(tongue(p, look), out.sprites);
        if (part == FirePart::Base && p.age < kBaseLife) add(base(p, look), out.sprites);
        if (part == FirePart::Smoke && look.smoke > 0) add(smoke(p, look), out.sprites);
        if (part == FirePart::Spark) add(spark(p), sparks);
    }
    out.flames = out.sprites.size();
    out.sprites.insert(out.sprites.end(), sparks.begin(), sparks.end());
    return out;
}

}  // namespace ember
