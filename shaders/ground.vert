// The ground: how much sky the paper hides, and what the flames throw. Both are smooth, so they are
// computed where the vertices are, which lie densely below the paper.
// in  place on the ground [m]
// out the place [m]; light of the flames; share of the sky that is seen 0 .. 1

layout(location = 0) in vec2 a_place;
uniform mat4 u_view, u_projection;
uniform int u_occluder_count;
uniform vec4 u_occluders[24], u_occluder_normals[24];  // discs: xyz [m], w area [m^2]; unit normals
out vec3 v_place;
out float v_flame;
out float v_open;

void main() {
    v_place = vec3(a_place.x, 0.0, a_place.y);
    float hidden = 0.0;
    for (int i = 0; i < u_occluder_count; ++i) {
        // form factor of a small disc
        vec3 to = u_occluders[i].xyz - v_place;
        float squared = dot(to, to) + 1e-6;
        float faces = abs(dot(to, u_occluder_normals[i].xyz)) + 0.02 * sqrt(squared);
        hidden += u_occluders[i].w * max(to.y, 0.0) * faces /
                  (squared * (3.14159 * squared + u_occluders[i].w));
    }
    v_open = max(1.0 - 1.6 * hidden, 0.1);
    v_flame = flame_irradiance(v_place, vec3(0.0, 1.0, 0.0), 0.0).x;
    gl_Position = u_projection * (u_view * vec4(v_place, 1.0));
}
