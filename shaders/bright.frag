// What is too bright for the film, to be spread around it: the light beyond 2.25 times paper white.
// in  v_uv; scene and fire, linear RGB, premultiplied
// out linear RGB

in vec2 v_uv;
uniform sampler2D u_scene, u_fire;
uniform int u_has_fire;
uniform float u_exposure;
out vec4 o_colour;

void main() {
    vec3 light = texture(u_scene, v_uv).rgb;
    if (u_has_fire != 0) {
        vec4 fire = texture(u_fire, v_uv);
        light = light * (1.0 - fire.a) + fire.rgb;
    }
    o_colour = vec4(beyond_film(light * u_exposure), 1.0);
}
