// The sheets as the lamp sees them.
// in  position [m]
// out distance along the lamp's light, 0 .. 1

layout(location = 0) in vec3 a_position;
out float v_distance;

void main() {
    vec3 at = (u_shadow_from_world * vec4(a_position, 1.0)).xyz;
    v_distance = at.z;
    gl_Position = vec4(at * 2.0 - 1.0, 1.0);
}
