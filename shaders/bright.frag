// What is too bright for the film, for the bloom. Energy above the threshold is kept, below it is 0.
// in  v_uv; scene and fire, linear RGB
// out linear RGB

in vec2 v_uv;
uniform sampler2D u_scene, u_fire;
uniform int u_has_fire;
uniform float u_exposure;
out vec4 o_colour;

void main() {
    vec3 light = texture(u_scene, v_uv).rgb;
    if (u_has_fire != 0) light += texture(u_fire, v_uv).rgb;
    light *= u_exposure;
    float peak = max(light.r, max(light.g, light.b));
    o_colour = vec4(light * (max(peak - 1.1, 0.0) / max(peak, 1e-4)), 1.0);
}
