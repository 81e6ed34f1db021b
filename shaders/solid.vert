// The lighter: a plain lit solid.
// in  position [m], unit normal
// out the same

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
uniform mat4 u_view, u_projection;
out vec3 v_place, v_normal;

void main() {
    v_place = a_position;
    v_normal = a_normal;
    gl_Position = u_projection * (u_view * vec4(a_position, 1.0));
}
