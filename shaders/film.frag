// The film: scene + fire + bloom, tone mapped and encoded.
// in  v_uv; linear RGB
// out sRGB-encoded RGB (encoded here because framebuffers that encode do so differently from
//     processor to processor)

in vec2 v_uv;
uniform sampler2D u_scene, u_fire, u_bloom;
uniform int u_has_fire, u_plain;
uniform float u_exposure;
out vec4 o_colour;

vec3 encode(vec3 c) {
    c = clamp(c, 0.0, 1.0);
    return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}

// The brightest channel follows a shoulder; the ratios between channels are kept, so that orange
// stays orange, until light is so strong that film would burn out to white.
vec3 develop(vec3 c) {
    float peak = max(c.r, max(c.g, max(c.b, 1e-5)));
    float toned = 1.0 - exp(-1.25 * peak);
    vec3 ratio = c / peak;
    float burnt_out = smoothstep(1.6, 9.0, peak);
    ratio = mix(ratio, vec3(1.0, 0.97, 0.86), 0.62 * burnt_out);
    return ratio * toned;
}

void main() {
    vec3 light = texture(u_scene, v_uv).rgb;
    if (u_has_fire != 0) light += texture(u_fire, v_uv).rgb;
    if (u_plain == 0) {
        light = light * u_exposure + 0.35 * texture(u_bloom, v_uv).rgb;
        light = develop(light);
    }
    o_colour = vec4(encode(light), 1.0);
}
