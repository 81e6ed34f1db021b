// The light of one fire particle, added to what is there.
// in  place in the atlas, heat, fade, distance [m]
// out linear RGB, additive; alpha counts coverage

in vec2 v_sprite;
in float v_heat;
in float v_fade;
in float v_distance;
uniform mat4 u_projection;
uniform sampler2D u_sprites;            // a: density of the flame
uniform sampler2D u_ramp;               // light by heat
uniform sampler2D u_depth;              // of the scene, 0 .. 1
uniform vec2 u_pixels;                  // size of this buffer
uniform float u_brightness;
out vec4 o_colour;

void main() {
    float density = texture(u_sprites, v_sprite).a;
    // distance of the scene behind this pixel, and how far in front of it the flame hovers
    float z = texture(u_depth, gl_FragCoord.xy / u_pixels).r * 2.0 - 1.0;
    float scene = u_projection[3][2] / (z + u_projection[2][2]);
    float soft = clamp((scene - v_distance) / 0.008 + 0.75, 0.0, 1.0);
    float strength = density * v_fade * soft;
    // dense cores are hotter than their edges
    float heat = clamp(v_heat * (0.72 + 0.34 * density), 0.0, 1.0);
    vec3 light = texture(u_ramp, vec2((heat * 255.0 + 0.5) / 256.0, 0.5)).rgb;
    o_colour = vec4(light * strength * 0.15 * u_brightness, strength * 0.05);
}
