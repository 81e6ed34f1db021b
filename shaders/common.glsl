// Shared by every shader: lights and noise. Lengths in metres, colours linear RGB.

uniform vec3 u_eye;             // camera position [m]
uniform float u_key_light;      // brightness of the studio light
uniform int u_light_count;
uniform vec4 u_lights[8];       // flames: xyz [m], w strength
uniform float u_flame_light;

const vec3 kKeyDirection = vec3(0.48, 0.62, 0.62);   // towards the studio light, nearly a unit
const vec3 kKeyColour = vec3(1.00, 0.97, 0.92);
const vec3 kSkyColour = vec3(0.20, 0.23, 0.28);
const vec3 kGroundColour = vec3(0.10, 0.085, 0.07);
const vec3 kFlameColour = vec3(1.00, 0.46, 0.13);

// The backdrop by place in the picture (0 .. 1 from the lower left corner): a soft vertical gradient.
vec3 backdrop(vec2 uv) {
    vec3 gradient = mix(vec3(0.010, 0.011, 0.013), vec3(0.030, 0.034, 0.041),
                        smoothstep(0.17, 0.75, uv.y));
    return gradient * (1.0 - 0.35 * dot(uv - 0.5, uv - 0.5));
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

// Light that falls on a surface with normal n at `place` from the flames.
vec3 flame_irradiance(vec3 place, vec3 n, float wrap) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < u_light_count; ++i) {
        vec3 to = u_lights[i].xyz - place;
        float squared = dot(to, to) + 0.0025;     // a flame is no point: 5 cm soft
        float facing = (dot(n, to) * inversesqrt(squared) + wrap) / (1.0 + wrap);
        sum += kFlameColour * (u_lights[i].w * max(facing, 0.0) * 0.03 / squared);
    }
    return sum * u_flame_light;
}

// Light from studio and sky.
vec3 studio_irradiance(vec3 n, float wrap) {
    float facing = max((dot(n, normalize(kKeyDirection)) + wrap) / (1.0 + wrap), 0.0);
    vec3 sky = mix(kGroundColour, kSkyColour, n.y * 0.5 + 0.5);
    return u_key_light * (kKeyColour * facing * 0.95 + sky);
}
