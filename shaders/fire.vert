// A strip of fire that turns about its axis to face the camera.
// in  tail and head [m]; half width [m], row, frame, mirror; heat, flame, blue, smoke (fire_sprites.h)
// out place in two neighbouring pictures of the flipbook and their mix, the rest as it is

layout(location = 0) in vec3 a_tail;
layout(location = 1) in vec3 a_head;
layout(location = 2) in vec4 a_shape;
layout(location = 3) in vec4 a_amount;
uniform mat4 u_view, u_projection;
out vec2 v_first, v_second;             // 0 .. 1 in the atlas
flat out float v_mix;
flat out vec4 v_amount;
out float v_up;                         // 0 at the tail, 1 at the head
out float v_distance;                   // [m] from the camera along its axis
out float v_height;                     // [m] above the floor

const vec2 kCells = vec2(16.0, 5.0);

void main() {
    vec2 corner = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, gl_VertexID < 2 ? 0.0 : 1.0);
    vec3 tail = (u_view * vec4(a_tail, 1.0)).xyz, head = (u_view * vec4(a_head, 1.0)).xyz;
    // tongues leave the borders of their cells empty, so these are not drawn
    vec2 used = a_shape.y < 3.5 ? vec2(0.80, 0.95) : vec2(1.0);
    vec2 axis = head.xy - tail.xy;
    float extent = length(axis);
    vec2 along = extent > 1e-6 ? axis / extent : vec2(0.0, 1.0);
    // seen along its axis, a flame is as wide as it is long
    float missing = max(2.0 * a_shape.x - extent, 0.0);
    corner *= used;
    vec3 place = mix(tail, head, corner.y);
    place.xy += along * (corner.y - 0.5) * missing + vec2(along.y, -along.x) * corner.x * a_shape.x;
    gl_Position = u_projection * vec4(place, 1.0);
    v_distance = -place.z;
    v_up = corner.y;
    v_height = mix(a_tail.y, a_head.y, corner.y);
    v_mix = fract(a_shape.z);
    v_amount = a_amount;
    vec2 in_cell = vec2(0.5 + 0.5 * corner.x * a_shape.w, 1.0 - corner.y);
    float frame = floor(a_shape.z);
    v_first = (vec2(frame, a_shape.y) + in_cell) / kCells;
    v_second = (vec2(min(frame + 1.0, kCells.x - 1.0), a_shape.y) + in_cell) / kCells;
}
