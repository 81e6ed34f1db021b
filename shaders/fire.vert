// One billboard per fire particle, stretched along its flight.
// in  position [m], velocity [m/s], (heat 1 .. 0, share of life 0 .. 1, seed 0 .. 1)
// out place in the sprite, and what its light depends on

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_velocity;
layout(location = 2) in vec3 a_state;
uniform mat4 u_view, u_projection;
uniform float u_size;                   // radius at birth temperature [m]
out vec2 v_sprite;                      // 0 .. 1 in the atlas
out float v_heat;
out float v_fade;
out float v_distance;                   // [m] from the camera along its axis

void main() {
    vec2 corner = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, gl_VertexID < 2 ? -1.0 : 1.0);
    float heat = a_state.x, life = a_state.y, seed = a_state.z;
    vec4 centre = u_view * vec4(a_position, 1.0);
    vec2 flight = (u_view * vec4(a_velocity, 0.0)).xy;
    float speed = length(flight);
    vec2 along = speed > 1e-4 ? flight / speed : vec2(0.0, 1.0);
    vec2 across = vec2(along.y, -along.x);
    // a flame starts small at the paper, swells, and thins out as it cools
    float swell = smoothstep(0.0, 0.22, life);
    float size = u_size * (0.30 + 0.70 * swell) * (0.45 + 0.55 * heat) * (0.75 + 0.5 * seed);
    float stretch = 1.0 + min(1.1 * speed, 1.6);
    centre.xy += (across * corner.x / sqrt(stretch) + along * corner.y * sqrt(stretch)) * size;
    gl_Position = u_projection * centre;
    v_distance = -centre.z;
    v_heat = heat;
    v_fade = smoothstep(0.0, 0.10, life) * (1.0 - smoothstep(0.55, 1.0, life));
    float index = floor(seed * 4.0);
    vec2 cell = vec2(mod(index, 2.0), floor(index * 0.5));
    float mirror = fract(seed * 37.0) < 0.5 ? -1.0 : 1.0;
    v_sprite = (cell + vec2(corner.x * mirror, -corner.y) * 0.49 + 0.5) * 0.5;
}
