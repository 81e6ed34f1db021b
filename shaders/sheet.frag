// Paper, scorch, char, ember line and ash, laid out in millimetres of the unburnt sheet.
// in  see sheet.vert
// out linear RGB; glow is far above 1 and left to the film; alpha: coverage of torn edges

in vec3 v_place, v_normal;
in vec4 v_fields;
in vec2 v_sheet, v_cell, v_page;
flat in vec2 v_size;
flat in float v_grain;
flat in int v_edges;
in vec2 v_flame;                        // light of the flames on the face with the normal, and behind
uniform sampler2D u_scorch;             // reflectance by mm ahead of the char line, 0 .. 32
uniform sampler2D u_ember;              // light by mm behind the ember line, 0 .. 4
uniform sampler2D u_fibre, u_crackle;   // see textures/make_textures.cpp
uniform sampler2D u_front, u_back;      // what is printed on both faces, sRGB-encoded
uniform vec3 u_char, u_ash_dark, u_ash_pale;
uniform int u_samples;                  // per pixel
uniform int u_wireframe;
uniform int u_inside;                   // whether this shell is between the faces: seen at edges
uniform int u_layer;                    // 0 the picture, else an ingredient (PaperLayer)
out vec4 o_colour;

const float kScorchEnd = 32.0, kEmberEnd = 4.0;     // [mm]
const int kTornSide = 1, kTornCorner = 16, kBorderSide = 256;   // render/sheet_vertices.h

vec3 look_up(sampler2D table, float x) {
    return texture(table, vec2((clamp(x, 0.0, 1.0) * 255.0 + 0.5) / 256.0, 0.5)).rgb;
}

// Distance to sides of this quad of these kinds, and to corners where torn sides meet [mm].
float to_edge(int kinds) {
    if ((v_edges & (kinds == kTornSide ? 255 : -1)) == 0) return 1e3;
    vec4 side = vec4(v_cell.y, 1.0 - v_cell.x, 1.0 - v_cell.y, v_cell.x) * v_size.yxyx;
    float nearest = 1e3;
    for (int k = 0; k < 4; ++k) {
        if ((v_edges & (kinds << k)) != 0) nearest = min(nearest, side[k]);
        if ((v_edges & (kTornCorner << k)) != 0) nearest = min(nearest, length(vec2(side[k], side[(k + 3) & 3])));
    }
    return nearest;
}

// The normal of a surface whose height above the sheet is `height` [m], from differences between
// neighbouring pixels.
vec3 embossed(vec3 n, float height) {
    vec3 dx = dFdx(v_place), dy = dFdy(v_place);
    vec3 across = cross(dy, n), along = cross(n, dx);
    float area = dot(dx, across);
    vec3 slope = sign(area) * (dFdx(height) * across + dFdy(height) * along);
    return normalize(max(abs(area), 1e-20) * n - slope);   // of pixels that see nothing, n
}

// How much of this pixel a line along the edges of the quad covers.
float on_edge() {
    vec2 from_edge = min(v_cell, 1.0 - v_cell) / max(fwidth(v_cell), 1e-5);   // [pixels]
    return 1.0 - clamp(min(from_edge.x, from_edge.y) - 0.2, 0.0, 1.0);
}

void main() {
    vec2 mm = v_sheet + v_grain * vec2(17.3, 29.7);
    vec4 fibre = texture(u_fibre, mm / 40.0);
    vec4 coarse = texture(u_fibre, mat2(0.8, 0.6, -0.6, 0.8) * mm / 131.0 + 0.37);
    vec2 wander = vec2(coarse.b, coarse.g) - 0.5;
    // two periods that share none, so that old ash, which is nothing but this, shows no tile
    float drift = 0.7 * (fibre.b + texture(u_fibre, mat2(-0.28, 0.96, -0.96, -0.28) * mm / 57.0).b - 1.0);

    // torn edges end in fibres
    float torn = to_edge(kTornSide) - 0.15 - 0.8 * fibre.b - 0.5 * fibre.a;
    float covered = clamp(torn / max(fwidth(torn), 1e-4) + 0.5, 0.0, 1.0);

    // noise moves the lines, so that they wander as fronts in fibres do
    float charred = v_fields.x + 9.0 * wander.x + 3.0 * (fibre.b - 0.5) + 0.5 * (fibre.a - 0.5);
    float burnt = v_fields.y + 7.0 * wander.x + 5.0 * wander.y + 3.0 * (fibre.b - 0.5);
    float pixel = fwidth(burnt);                    // [mm]
    float char_share = smoothstep(-0.8, 0.4, charred);

    // char cracks into flakes; embers eat into them from the cracks, and leave ash
    vec2 warped = mm + 9.0 * wander;
    vec3 crack = texture(u_crackle, warped / 48.0).rgb * vec3(4.0, 1.0, 1.0);   // [mm, 1, mm]
    float age = v_fields.z;
    float eaten = (age - 0.5 - 2.5 * coarse.g) * (0.25 + 0.35 * crack.g);       // [mm] from cracks
    float reach = 0.12 + 0.9 * crack.g * crack.g * crack.g + 0.9 * (coarse.b - 0.45);   // [mm] at most
    float behind_crawl = min(eaten, reach) - crack.r - 0.7 * (fibre.b - 0.5);
    float eaten_share = smoothstep(-0.25, 0.6, behind_crawl) * smoothstep(0.0, 1.5, burnt);
    float lip = smoothstep(0.3, 1.0, burnt) * (1.0 - smoothstep(2.5, 4.5, burnt)) *
                smoothstep(0.35, 0.65, fibre.b + 0.2 * fibre.a);
    float edge_ash = (1.0 - smoothstep(0.2, 1.5, torn)) * smoothstep(0.0, 3.0, burnt) *
                     smoothstep(0.45, 0.75, fibre.b + 0.4 * (coarse.g - 0.5));
    // a film of ash grows on what stays black, in drifts
    float spread = 0.38 - 0.40 * smoothstep(2.0, 14.0, age);
    float film = smoothstep(spread, spread + 0.5,
                            0.8 * coarse.g + 0.6 * drift + 0.3 * (crack.g - 0.5) + 0.1) *
                 smoothstep(0.4, 5.0, age);
    float ash = max(max(eaten_share, 0.8 * film), max(0.8 * lip, 0.7 * edge_ash));
    float pale = smoothstep(0.2, 6.0, age + 3.0 * (coarse.b - 0.5)) * (0.85 + 0.5 * drift);
    // all char greys a little with time
    float dust = 0.9 * smoothstep(1.0, 12.0, age) * (0.5 + 0.8 * fibre.g);

    bool faces = dot(v_normal, u_eye - v_place) > 0.0;
    vec2 page = vec2(faces ? v_page.x : 1.0 - v_page.x, v_page.y);
    vec4 print = faces ? texture(u_front, page) : texture(u_back, page);
    print.rgb = mix(vec3(1.0), print.rgb, print.a);
    float ink = 1.0 - dot(print.rgb, vec3(0.30, 0.59, 0.11));

    vec3 paper = look_up(u_scorch, -charred / kScorchEnd);
    paper *= 0.93 + 0.07 * fibre.r + 0.05 * (fibre.g - 0.5);
    paper *= mix(vec3(0.02), vec3(1.0), print.rgb * print.rgb * (0.3 + 0.7 * print.rgb));   // decoded
    vec3 black = mix(u_char, u_ash_dark, dust) * (0.75 + 0.5 * fibre.r);
    black += 0.022 * ink;               // pigments stay on the char, and shine
    vec3 grey = mix(u_ash_dark, u_ash_pale, clamp(pale, 0.0, 1.0)) * (0.8 + 0.4 * fibre.r);
    vec3 burnt_albedo = mix(black, grey, ash);
    burnt_albedo *= mix(1.0, smoothstep(0.0, 0.22, crack.r), 0.7 * smoothstep(0.0, 4.0, burnt));
    burnt_albedo *= 1.0 - 0.35 * ink * ash;
    vec3 albedo = mix(paper, burnt_albedo, char_share);

    // relief: fibres, blisters near the front, flakes that curl up at their edges
    float flakes = smoothstep(0.0, 6.0, charred);
    float height = 4e-6 * fibre.r + 25e-6 * char_share * fibre.b +
                   flakes * (1.3e-4 * smoothstep(0.0, 0.9, crack.r) - 1.5e-4 * crack.r * 0.35 +
                             3e-5 * smoothstep(0.0, 0.5, crack.b)) +
                   1.6e-3 * wander.y * smoothstep(-14.0, 0.0, charred);
    // torn edges are bevelled; what shows between the faces is a wall, which slopes steeply
    height += u_inside != 0 ? 4e-3 * min(torn, to_edge(kTornSide | kBorderSide)) : 6e-5 * smoothstep(0.0, 0.14, torn);
    vec3 n = normalize(v_normal);
    vec3 to_eye = normalize(u_eye - v_place);
    if (!faces) n = -n;
    n = embossed(n, height);

    float translucency = 0.22 * (0.8 + 0.4 * fibre.g) * (1.0 - smoothstep(-8.0, -1.0, charred));
    vec2 flame = faces ? v_flame : v_flame.yx;
    float visible = key_visibility(v_place);
    vec3 front = studio_irradiance(visible, n, 0.15) + kFlameColour * flame.x;
    vec3 back = studio_irradiance(visible, -n, 0.15) + kFlameColour * flame.y;
    vec3 light = albedo * (front * (1.0 - translucency) + back * translucency);

    // satin sheen of char, faint of paper
    vec3 halfway = normalize(to_eye + u_key_direction);
    float gloss = mix(0.03, (0.16 + 0.20 * ink) * (1.0 - 0.9 * ash), char_share);
    float fresnel = 0.04 + 0.5 * pow(1.0 - clamp(dot(n, to_eye), 0.0, 1.0), 5.0);
    light += gloss * (u_key * pow(max(dot(n, halfway), 0.0), 22.0) +
                      fresnel * (2.0 * u_sky + 0.4 * kFlameColour * flame.x));

    // embers: the line where char burns out, and what crawls on along cracks until it winks out
    float hot = smoothstep(350.0, 650.0, v_fields.w);
    float wide = max(1.0, pixel / 0.5);
    float segments = smoothstep(0.25, 0.6, fibre.b + 0.35 * (coarse.g - 0.5));
    vec3 glow = look_up(u_ember, burnt / wide / kEmberEnd) * (segments / wide) * hot;
    float alive = 1.0 - smoothstep(0.25, 1.0, age / (0.6 + 4.0 * crack.g * crack.g * crack.g + 1.2 * fibre.b));
    float crawl_pixel = max(0.18, fwidth(behind_crawl));
    float crawl = exp(-behind_crawl * behind_crawl / (crawl_pixel * crawl_pixel)) * 0.18 / crawl_pixel;
    glow += vec3(2.6, 0.60, 0.05) * (crawl * alive * smoothstep(0.2, 2.0, burnt)) *
            smoothstep(0.50, 0.72, fibre.b + 0.9 * (coarse.g - 0.55));
    // what burns glows dully in its cracks
    float burning = smoothstep(0.0, 3.0, charred) * (1.0 - smoothstep(-2.0, 0.5, burnt));
    glow += vec3(0.50, 0.055, 0.004) * (burning * hot * (1.0 - smoothstep(0.0, 0.45, crack.r)) *
            smoothstep(0.52, 0.75, fibre.b + 0.5 * (coarse.g - 0.5)));

    light += glow;
    if (u_wireframe != 0) light = mix(light, vec3(0.05, 0.35, 0.75), 0.8 * on_edge());

    // Last: differences between neighbouring pixels, which textures need, too, are undefined once one
    // of them is gone. Graphics cards make NaN of them.
    if (covered < (u_samples > 1 ? 0.02 : 0.5)) discard;

    // ingredients, for compositing (PaperLayer)
    if (u_layer == 1) { o_colour = vec4(albedo, 1.0); return; }
    if (u_layer == 2) { o_colour = vec4(glow, 1.0); return; }
    if (u_layer == 3) { o_colour = vec4(n, 1.0); return; }
    if (u_layer == 4) {
        float phase = v_fields.y > 0.0 ? 2.0 : v_fields.x > 0.0 ? 1.0 : 0.0;
        o_colour = vec4(1.0 / gl_FragCoord.w, v_fields.w, phase, 1.0);
        return;
    }
    o_colour = vec4(light, u_samples > 1 ? covered : 1.0);
}
