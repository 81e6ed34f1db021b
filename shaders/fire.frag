// What one sprite adds to the fire: amounts, not yet light, so that order does not matter.
// in  places in the flipbook and their mix; amounts of heat, flame, blue, smoke; distance and
//     height [m]
// out r flame (optical depth), g flame times heat, b blue light, a smoke (optical depth)

in vec2 v_first, v_second;
flat in float v_mix;
flat in vec4 v_amount;
in float v_up;
in float v_distance;
in float v_height;
uniform mat4 u_projection;
uniform sampler2D u_sprites;            // r heat, a density
uniform sampler2D u_depth;              // of the scene, 0 .. 1
uniform vec2 u_pixels;                  // size of this buffer
uniform float u_floor;                  // [m] height that no fire reaches below
out vec4 o_amount;

void main() {
    vec2 sprite = mix(texture(u_sprites, v_first).ra, texture(u_sprites, v_second).ra, v_mix);
    // distance of the scene behind this pixel: fire fades where it enters the paper
    float z = texture(u_depth, gl_FragCoord.xy / u_pixels).r * 2.0 - 1.0;
    float scene = u_projection[3][2] / (z + u_projection[2][2]);
    float density = sprite.g * clamp((scene - v_distance) / 0.014 + 0.7, 0.0, 1.0) *
                    clamp((v_height - u_floor) / 0.014 + 0.7, 0.0, 1.0);
    // gas has to rise a little before its soot glows
    float flame = v_amount.y * density * smoothstep(0.02, 0.45, v_up);
    float low = 1.0 - smoothstep(0.05, 0.24, v_up);
    o_amount = vec4(flame, flame * v_amount.x * sprite.r, v_amount.z * density * low,
                    v_amount.w * density);
}
