// Paper.
// in  position [m], unit normal, fields (render/sheet_fields.h: mm behind the char line, mm behind
//     the ember line, s since burnout, degC), quantity of a view; place on the unburnt sheet [mm],
//     in its quad (0 .. 1), size of the quad [mm], place on the printed page (0 .. 1), number of the
//     sheet, edges (render/sheet_vertices.h)
// out the same, interpolated; light of the flames on the face with the normal and on the other

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec4 a_fields;
layout(location = 3) in float a_quantity;
layout(location = 4) in vec4 a_sheet;   // u, v [mm], s, t
layout(location = 5) in vec4 a_page;    // size of the quad [mm], place on the page
layout(location = 6) in vec2 a_marks;   // number of the sheet, edges
uniform mat4 u_view, u_projection;
uniform float u_lift;                   // [m] of this shell above the middle of the sheet
out vec3 v_place, v_normal;
out vec4 v_fields;
out float v_quantity;
out vec2 v_sheet, v_cell, v_page;
flat out vec2 v_size;
flat out float v_grain;
flat out int v_edges;
out vec2 v_flame;

void main() {
    v_place = a_position + u_lift * a_normal;
    v_normal = a_normal;
    v_fields = a_fields;
    v_quantity = a_quantity;
    v_sheet = a_sheet.xy;
    v_cell = a_sheet.zw;
    v_size = a_page.xy;
    v_page = a_page.zw;
    v_grain = a_marks.x;
    v_edges = int(a_marks.y + 0.5);
    // flames are soft and far in terms of quads, so what they throw is interpolated
    v_flame = flame_irradiance(a_position, a_normal, 0.1);
    gl_Position = u_projection * (u_view * vec4(v_place, 1.0));
}
