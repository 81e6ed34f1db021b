// Shared by every shader: lights and noise. Lengths in metres, colours linear RGB.

uniform vec3 u_eye;             // camera position [m]
uniform vec3 u_key_direction;   // towards the lamp, a unit vector
uniform vec3 u_key, u_sky, u_bounce;  // light of the set (render/lighting.h)
uniform vec3 u_backdrop_mid, u_backdrop_edge;
uniform mat4 u_shadow_from_world;  // to 0 .. 1 in the shadow map
uniform sampler2D u_shadow;     // share of paper around; times its distance, and that squared
uniform int u_light_count;
uniform vec4 u_lights[16];      // flames: xyz [m], w strength
uniform float u_flame_light;

const vec3 kFlameColour = vec3(1.00, 0.46, 0.13);
const float kWallOfFlame = 1.8;  // of paper white, as bright as flames themselves

// The backdrop by place in the picture (0 .. 1 from the lower left corner): a pool of light that
// falls off without a horizon.
vec3 backdrop(vec2 uv) {
    vec2 from_middle = (uv - vec2(0.5, 0.56)) * vec2(1.0, 1.15);
    float far = smoothstep(0.0, 0.78, length(from_middle));
    return mix(u_backdrop_mid, u_backdrop_edge, far);
}

// Light beyond what film can show, which blooms: from 2.25 times paper white, 0.75 here.
vec3 beyond_film(vec3 light) {
    float peak = max(light.r, max(light.g, light.b));
    return light * (max(peak - 1.7, 0.0) / max(peak, 1e-4));
}

// A cheap hash in [0, 1) without trigonometry, which would differ between processors.
float hash(vec2 p) {
    vec3 q = fract(vec3(p.xyx) * vec3(0.1031, 0.1030, 0.0973));
    q += dot(q, q.yzx + 33.33);
    return fract((q.x + q.y) * q.z);
}

float value_noise(vec2 p) {
    vec2 cell = floor(p), t = fract(p);
    t = t * t * (3.0 - 2.0 * t);
    return mix(mix(hash(cell), hash(cell + vec2(1, 0)), t.x),
               mix(hash(cell + vec2(0, 1)), hash(cell + vec2(1, 1)), t.x), t.y);
}

// Four octaves, in [0, 1], mean 0.5.
float fractal_noise(vec2 p) {
    float sum = 0.0, weight = 0.5;
    for (int i = 0; i < 4; ++i) {
        sum += weight * value_noise(p);
        p = mat2(1.6, 1.2, -1.2, 1.6) * p;
        weight *= 0.5;
    }
    return sum / 0.9375;
}

// Light of the flames that falls on both faces of a surface with normal n at `place`, on the face
// with the normal first; times kFlameColour.
vec2 flame_irradiance(vec3 place, vec3 n, float wrap) {
    vec2 sum = vec2(0.0);
    for (int i = 0; i < u_light_count; ++i) {
        vec3 to = u_lights[i].xyz - place;
        float squared = dot(to, to) + 0.0025;     // a flame is no point: 5 cm soft
        float facing = dot(n, to) * inversesqrt(squared);
        sum += u_lights[i].w / squared * max(vec2(facing, -facing) + wrap, 0.0);
    }
    // flames hide each other: however many, they throw no more than a wall of flame does
    return u_flame_light * kWallOfFlame * (1.0 - exp(-sum * (0.03 / (1.0 + wrap) / kWallOfFlame)));
}

// Share of the lamp that reaches `place`, 0 .. 1. Of the paper around the line to the lamp, how much
// is nearer to the lamp follows from the mean and variance of its distance (Chebyshev's bound).
float key_visibility(vec3 place) {
    vec3 at = (u_shadow_from_world * vec4(place, 1.0)).xyz;
    vec3 paper = texture(u_shadow, at.xy).rgb;
    if (paper.r < 0.004) return 1.0;
    vec2 moments = paper.gb / paper.r;
    float behind = at.z - 0.012 - moments.x;
    if (behind <= 0.0) return 1.0;
    float variance = max(moments.y - moments.x * moments.x, 1e-4);
    float passes = smoothstep(0.15, 1.0, variance / (variance + behind * behind));
    return 1.0 - paper.r * (1.0 - passes);
}

// Light of the set on a surface with normal n: the share of the lamp that is visible, and the sky.
vec3 studio_irradiance(float visible, vec3 n, float wrap) {
    float facing = max((dot(n, u_key_direction) + wrap) / (1.0 + wrap), 0.0);
    return u_key * (facing * visible) + mix(u_bounce, u_sky, n.y * 0.5 + 0.5);
}
