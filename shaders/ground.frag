// The ground: a matt floor that sweeps up into the backdrop, so that there is no horizon.
// in  place [m]; light of the flames; share of the sky that is seen
// out linear RGB

in vec3 v_place;
in float v_flame;
in float v_open;
uniform float u_albedo;
uniform vec2 u_pixels;                  // size of the picture [pixels]
out vec4 o_colour;

void main() {
    float facing = u_key_direction.y;
    vec3 light = u_key * (facing * key_visibility(v_place)) + u_sky;
    // the lamp's pool of light ends where the sweep begins
    float away = length(v_place.xz);
    vec3 lit = u_albedo * (light * v_open * (1.0 - smoothstep(0.2, 1.1, away)) +
                                   kFlameColour * v_flame);
    o_colour = vec4(mix(lit, backdrop(gl_FragCoord.xy / u_pixels), smoothstep(0.25, 1.25, away)), 1.0);
}
