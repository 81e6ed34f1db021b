// Letters and colours of a view's legend, over the developed picture.
// in  place in the font [pixels], linear RGB
// out sRGB-encoded RGB

in vec2 v_font;
in vec3 v_colour;
uniform sampler2D u_font;
out vec4 o_colour;

void main() {
    if (texelFetch(u_font, ivec2(v_font), 0).r < 0.5) discard;
    vec3 c = clamp(v_colour, 0.0, 1.0);
    c = mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
    o_colour = vec4(c, 1.0);
}
