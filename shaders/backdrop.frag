// The studio behind the paper: a soft vertical gradient.
// in  v_uv
// out linear RGB

in vec2 v_uv;
out vec4 o_colour;

void main() {
    float vignette = 1.0 - 0.35 * dot(v_uv - 0.5, v_uv - 0.5);
    o_colour = vec4(backdrop(v_uv.y * 1.2 - 0.45) * vignette, 1.0);
}
