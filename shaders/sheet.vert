// Paper.
// in  position [m], unit normal, place on the unburnt sheet [mm],
//     state: burn progress (palette.h), temperature [degC], mass left [1], phase 0 1 2
// out the same, interpolated, and the light of the flames on both faces

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec2 a_sheet;
layout(location = 3) in vec4 a_state;
uniform mat4 u_view, u_projection;
out vec3 v_place, v_normal;
out vec2 v_sheet;
out vec4 v_state;
out vec2 v_flame;                       // on the face with the normal, and on the other

void main() {
    v_place = a_position;
    v_normal = a_normal;
    v_sheet = a_sheet;
    v_state = a_state;
    // flames are soft and far in terms of quads, so what they throw is interpolated
    v_flame = vec2(flame_irradiance(a_position, a_normal, 0.1),
                   flame_irradiance(a_position, -a_normal, 0.1));
    gl_Position = u_projection * (u_view * vec4(a_position, 1.0));
}
