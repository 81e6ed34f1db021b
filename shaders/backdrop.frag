// The studio behind the paper.
// in  v_uv
// out linear RGB

in vec2 v_uv;
out vec4 o_colour;

void main() {
    o_colour = vec4(backdrop(v_uv), 1.0);
}
