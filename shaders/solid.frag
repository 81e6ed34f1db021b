// The lighter: a dull metal.
// in  place [m], unit normal
// out linear RGB

in vec3 v_place, v_normal;
uniform float u_albedo;
out vec4 o_colour;

void main() {
    vec3 n = normalize(v_normal);
    vec3 light = studio_irradiance(key_visibility(v_place), n, 0.0) + kFlameColour * flame_irradiance(v_place, n, 0.0).x;
    vec3 mirrored = reflect(normalize(v_place - u_eye), n);
    float shine = pow(max(dot(mirrored, u_key_direction), 0.0), 24.0);
    o_colour = vec4(u_albedo * light + 0.6 * shine * u_key, 1.0);
}
