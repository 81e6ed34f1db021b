// The panels.
// in  place in the font atlas, sRGB colour with straight alpha
// out the same, blended by the caller; the film has already been developed, so nothing is encoded

in vec2 v_uv;
in vec4 v_colour;
uniform sampler2D u_font;
out vec4 o_colour;

void main() { o_colour = v_colour * texture(u_font, v_uv); }
