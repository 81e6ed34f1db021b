// Turns the amounts that the sprites add up to into light and what it covers.
// in  v_uv; amounts (fire.frag)
// out linear RGB, premultiplied: light that the fire sends, and in alpha how much it hides

in vec2 v_uv;
uniform sampler2D u_amounts;
uniform sampler2D u_ramp;               // light by heat
uniform float u_brightness;
uniform vec3 u_smoke_light;             // light on the smoke
out vec4 o_colour;

const vec3 kBlue = vec3(0.03, 0.07, 0.26);

void main() {
    vec4 amounts = texture(u_amounts, v_uv);
    float depth = amounts.r;
    // thin gas is more transparent than in proportion, which keeps the tongues apart
    float flame = 1.0 - exp(-0.75 * depth * depth / (depth + 0.7));
    // where gas is deep it is seen at its hottest; thin tips are darker and redder
    float heat = 0.08 + 1.25 * amounts.g / max(depth, 1e-3) * (0.50 + 0.80 * flame);
    vec3 hot = texture(u_ramp, vec2((clamp(heat, 0.0, 1.0) * 255.0 + 0.5) / 256.0, 0.5)).rgb;
    vec3 light = hot * flame * u_brightness;
    light += kBlue * (1.0 - exp(-0.4 * amounts.b)) * u_brightness;
    float hides = 0.12 * flame;     // soot is thin: what is behind it shines through
    float smoke = (1.0 - exp(-0.4 * amounts.a)) * (1.0 - hides);
    o_colour = vec4(light + u_smoke_light * smoke, hides + smoke);
}
