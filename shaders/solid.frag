// Ground and lighter: diffuse light of studio and flames; the ground fades into the backdrop.
// in  place [m], unit normal
// out linear RGB

in vec3 v_place, v_normal;
uniform float u_albedo, u_fog;
uniform vec2 u_pixels;                  // size of the picture [pixels]
out vec4 o_colour;

void main() {
    vec3 n = normalize(v_normal);
    vec3 light = studio_irradiance(n, 0.0) * 0.28 + flame_irradiance(v_place, n, 0.0);
    vec3 colour = u_albedo * light;
    if (u_fog > 0.0) {
        colour *= 0.92 + 0.16 * fractal_noise(v_place.xz * 90.0);
        float distance_from_stage = length(v_place.xz);
        colour = mix(colour, backdrop(gl_FragCoord.xy / u_pixels),
                     smoothstep(0.10, 1.2, distance_from_stage));
    }
    o_colour = vec4(colour, 1.0);
}
