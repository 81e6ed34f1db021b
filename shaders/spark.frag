// A spark: a small hot body and its streak, added to the fire.
// in  place in the flipbook; heat and brightness; distance [m]
// out linear RGB, additive; alpha 0, because it hides nothing

in vec2 v_first;
flat in vec4 v_amount;
in float v_distance;
uniform mat4 u_projection;
uniform sampler2D u_sprites;
uniform sampler2D u_depth;              // of the scene, 0 .. 1
uniform sampler2D u_ramp;               // light by heat
uniform vec2 u_pixels;                  // size of this buffer
uniform float u_brightness;
out vec4 o_colour;

void main() {
    float z = texture(u_depth, gl_FragCoord.xy / u_pixels).r * 2.0 - 1.0;
    float scene = u_projection[3][2] / (z + u_projection[2][2]);
    float strength = texture(u_sprites, v_first).a * v_amount.y * step(v_distance, scene);
    vec3 hot = texture(u_ramp, vec2((clamp(v_amount.x, 0.0, 1.0) * 255.0 + 0.5) / 256.0, 0.5)).rgb;
    o_colour = vec4(hot * (8.0 * strength * u_brightness), 0.0);
}
