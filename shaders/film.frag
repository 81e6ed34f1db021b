// The film: scene over what is behind it + fire + bloom, tone mapped and encoded.
// in  v_uv; linear RGB, premultiplied with how much is covered
// out sRGB-encoded RGB (encoded here because framebuffers that encode do so differently from
//     processor to processor); when transparent, straight alpha so that encoded colour times alpha
//     is the picture over black

in vec2 v_uv;
uniform sampler2D u_scene, u_fire, u_bloom, u_background;
uniform int u_has_fire, u_plain, u_transparent;
uniform float u_exposure, u_bloom_share;
out vec4 o_colour;

// sRGB's curve by square roots, which are cheap and the same on every processor: within 0.3 of 255.
vec3 encode(vec3 c) {
    c = clamp(c, 0.0, 1.0);
    vec3 second = sqrt(c), fourth = sqrt(second), eighth = sqrt(fourth);
    vec3 curve = 0.662002687 * second + 0.684122060 * fourth - 0.323583601 * eighth - 0.0225411470 * c;
    return mix(12.92 * c, curve, step(0.0031308, c));
}

// The brightest channel follows a shoulder; the ratios between channels are kept, so that orange
// stays orange, until light is so strong that film would burn out to white.
vec3 develop(vec3 c) {
    float peak = max(c.r, max(c.g, max(c.b, 1e-5)));
    float toned = 1.0 - exp(-1.35 * peak);
    vec3 ratio = c / peak;
    float burnt_out = smoothstep(1.6, 9.0, peak);
    ratio = mix(ratio, vec3(1.0, 0.97, 0.86), 0.62 * burnt_out);
    return ratio * toned;
}

void main() {
    vec4 light = texelFetch(u_scene, ivec2(gl_FragCoord.xy), 0);
    if (u_transparent == 0) light = vec4(light.rgb + (1.0 - light.a) * texture(u_background, v_uv).rgb, 1.0);
    if (u_has_fire != 0) {
        vec4 fire = texture(u_fire, v_uv);
        light = light * (1.0 - fire.a) + fire;
    }
    if (u_plain == 2) {  // light as it is, for compositing
        o_colour = light;
        return;
    }
    if (u_plain == 0) {
        light.rgb *= u_exposure;
        // what spreads is taken from where it came: bloom adds no light
        if (u_bloom_share > 0.0)
            light.rgb += u_bloom_share * (texture(u_bloom, v_uv).rgb - beyond_film(light.rgb));
        light.rgb = develop(light.rgb);
    }
    vec3 encoded = encode(light.rgb);
    if (u_transparent != 0) {
        // light that covers nothing, such as a flame's, needs an alpha too, or it would be lost
        float alpha = max(clamp(light.a, 0.0, 1.0), max(encoded.r, max(encoded.g, encoded.b)));
        o_colour = vec4(encoded / max(alpha, 1.0 / 255.0), alpha);
        return;
    }
    // less than one step of noise, the same in every picture, so that dark gradients show no bands
    if (u_plain == 0) encoded += (hash(gl_FragCoord.xy) - 0.5) / 255.0;
    o_colour = vec4(encoded, 1.0);
}
