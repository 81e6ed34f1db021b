// Springs as coloured lines.
// in  position [m], linear RGB
// out the colour

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_colour;
uniform mat4 u_view, u_projection;
out vec3 v_colour;

void main() {
    v_colour = a_colour;
    gl_Position = u_projection * (u_view * vec4(a_position, 1.0));
}
