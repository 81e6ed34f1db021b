// A quantity of the paper by colour map, or its phase.
// in  see sheet.vert
// out linear RGB, to be shown as it is

in vec3 v_place, v_normal;
in float v_quantity;
in vec2 v_cell;
uniform sampler2D u_map;                // over 0 .. 1
uniform vec2 u_range;                   // quantity at both ends of the map
uniform int u_wireframe;
uniform int u_phases;                   // the quantity is a phase: 0, 1, 2
uniform vec3 u_unburnt, u_burning, u_burnt_out;
out vec4 o_colour;

// How much of this pixel a line along the edges of the quad covers.
float on_edge() {
    vec2 from_edge = min(v_cell, 1.0 - v_cell) / max(fwidth(v_cell), 1e-5);   // [pixels]
    return 1.0 - clamp(min(from_edge.x, from_edge.y) - 0.2, 0.0, 1.0);
}

void main() {
    vec3 to_eye = normalize(u_eye - v_place);
    float shade = 0.55 + 0.45 * abs(dot(normalize(v_normal), to_eye));
    float x = clamp((v_quantity - u_range.x) / (u_range.y - u_range.x), 0.0, 1.0);
    vec3 colour = texture(u_map, vec2((x * 255.0 + 0.5) / 256.0, 0.5)).rgb;
    if (u_phases != 0) {
        colour = v_quantity < 0.5 ? u_unburnt : v_quantity < 1.5 ? u_burning : u_burnt_out;
    }
    colour *= shade;
    if (u_wireframe != 0) colour = mix(colour, vec3(0.0), 0.8 * on_edge());
    o_colour = vec4(colour, 1.0);
}
