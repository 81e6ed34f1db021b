// Letters and colours of a view's legend.
// in  place in the picture [pixels from the lower left corner], in the font [pixels], linear RGB
// out the last two

layout(location = 0) in vec2 a_place;
layout(location = 1) in vec2 a_font;
layout(location = 2) in vec3 a_colour;
uniform vec2 u_pixels;                  // size of the picture
out vec2 v_font;
out vec3 v_colour;

void main() {
    v_font = a_font;
    v_colour = a_colour;
    gl_Position = vec4(a_place / u_pixels * 2.0 - 1.0, 0.0, 1.0);
}
