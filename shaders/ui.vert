// The panels.
// in  position [points from the upper left corner], place in the font atlas, sRGB colour with alpha
// out the last two

layout(location = 0) in vec2 a_position;
layout(location = 1) in vec2 a_uv;
layout(location = 2) in vec4 a_colour;
uniform vec2 u_origin, u_size;          // of the display [points]
out vec2 v_uv;
out vec4 v_colour;

void main() {
    v_uv = a_uv;
    v_colour = a_colour;
    vec2 place = (a_position - u_origin) / u_size * 2.0 - 1.0;
    gl_Position = vec4(place.x, -place.y, 0.0, 1.0);
}
