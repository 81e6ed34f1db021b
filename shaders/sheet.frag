// Paper, scorch, ember line, char and ash; or a quantity by colour map.
// in  place [m], unit normal, place on the sheet [mm], state (sheet.vert)
// out linear RGB; glow is far above 1 and left to the film

in vec3 v_place, v_normal;
in vec2 v_sheet;
in vec4 v_state;
in vec2 v_flame;                        // light of the flames on the face with the normal, and behind
uniform int u_mode;                     // ViewMode
uniform sampler2D u_albedo, u_glow;     // by burn progress / 4
uniform sampler2D u_heat, u_mass;       // colour maps over 0 .. 1
uniform sampler2D u_fibre;              // r: grain, g: blotches
uniform float u_hottest;                // end of the temperature scale [degC]
uniform vec3 u_unburnt, u_burning, u_burnt_out;
out vec4 o_colour;

const float kTable = 256.0;

vec3 look_up(sampler2D table, float x) {
    return texture(table, vec2((clamp(x, 0.0, 1.0) * (kTable - 1.0) + 0.5) / kTable, 0.5)).rgb;
}

vec3 lit(vec3 albedo, float translucency, vec3 n) {
    vec2 flame = dot(n, v_normal) < 0.0 ? v_flame.yx : v_flame;
    vec3 front = studio_irradiance(v_place, n, 0.15) + kFlameColour * flame.x;
    vec3 back = studio_irradiance(v_place, -n, 0.15) + kFlameColour * flame.y;
    return albedo * (front * (1.0 - translucency) + back * translucency);
}

void main() {
    vec3 n = normalize(v_normal);
    if (dot(n, u_eye - v_place) < 0.0) n = -n;
    float shade = 0.55 + 0.45 * max(dot(n, normalize(u_eye - v_place)), 0.0);

    if (u_mode == 2) {
        o_colour = vec4(look_up(u_heat, v_state.y / u_hottest) * shade, 1.0);
        return;
    }
    if (u_mode == 3) {
        o_colour = vec4(look_up(u_mass, v_state.z) * shade, 1.0);
        return;
    }
    if (u_mode == 4) {
        vec3 flat_colour = v_state.w < 0.5 ? u_unburnt : v_state.w < 1.5 ? u_burning : u_burnt_out;
        o_colour = vec4(flat_colour * shade, 1.0);
        return;
    }

    // fibres shift the burn progress, so that no edge follows the lattice
    float coarse = fractal_noise(v_sheet * 0.16);
    float fine = fractal_noise(v_sheet * vec2(0.55, 0.9) + 17.0);
    float progress = v_state.x;
    float near_front = smoothstep(0.02, 0.35, progress) * (1.0 - smoothstep(1.5, 2.2, progress));
    progress += near_front * (0.46 * (coarse - 0.5) + 0.09 * (fine - 0.5));

    vec4 fibre = texture(u_fibre, v_sheet / 64.0);
    vec3 albedo = look_up(u_albedo, progress / 4.0);
    float paper = 1.0 - smoothstep(0.1, 0.7, progress);
    albedo *= mix(1.0, 0.90 + 0.12 * fibre.r + 0.06 * fibre.g, paper);

    // ash is patchy: pale flakes with dark cracks between them
    float ash = smoothstep(2.1, 3.2, progress);
    float flakes = smoothstep(0.22, 0.80, fractal_noise(v_sheet * 0.11 + 5.0));
    float cracks = smoothstep(0.0, 0.05, abs(fractal_noise(v_sheet * 0.16 + 40.0) - 0.5));
    albedo *= mix(1.0, (0.45 + 0.95 * flakes) * (0.55 + 0.45 * cracks) * (0.7 + 0.6 * fibre.r), ash);

    // embers need heat: where ash borders on cold paper nothing glows
    float hot = smoothstep(330.0, 620.0, v_state.y);
    float crackle = mix(1.0, smoothstep(0.34, 0.72, fine) * 1.7, smoothstep(1.10, 1.45, progress));
    vec3 glow = look_up(u_glow, progress / 4.0) * hot * crackle;

    o_colour = vec4(lit(albedo, 0.22 * paper, n) + glow, 1.0);
}
