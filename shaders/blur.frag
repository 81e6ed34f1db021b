// One direction of a Gaussian blur, nine taps in five reads.
// in  v_uv; source, linear RGB; step between taps [uv]
// out linear RGB

in vec2 v_uv;
uniform sampler2D u_source;
uniform vec2 u_step;
out vec4 o_colour;

void main() {
    vec3 sum = texture(u_source, v_uv).rgb * 0.2270270;
    sum += (texture(u_source, v_uv + u_step * 1.3846154).rgb +
            texture(u_source, v_uv - u_step * 1.3846154).rgb) * 0.3162162;
    sum += (texture(u_source, v_uv + u_step * 3.2307692).rgb +
            texture(u_source, v_uv - u_step * 3.2307692).rgb) * 0.0702703;
    o_colour = vec4(sum, 1.0);
}
