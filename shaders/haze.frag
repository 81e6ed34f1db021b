// The scene as hot gas in the line of sight bends its light. Only run where haze is wanted.
// in  v_uv; scene, linear RGB, premultiplied; gas as optical depths
// out the scene, moved

in vec2 v_uv;
uniform sampler2D u_scene;
uniform sampler2D u_gas;            // r flame, a smoke
uniform vec2 u_pixels;              // size of the picture
uniform float u_haze;               // [pixels^2] shift by how fast gas thickens from pixel to pixel
out vec4 o_colour;

// Hot gas in the line of sight at `uv`, 0 .. 1.
float gas_at(vec2 uv) {
    vec4 amounts = texture(u_gas, uv);
    float gas = amounts.r + amounts.a;
    return gas / (gas + 1.0);
}

void main() {
    const float kReach = 3.0;       // [pixels] either way, more than those of u_gas
    vec2 reach = kReach / u_pixels;
    vec2 slope = vec2(gas_at(v_uv + vec2(reach.x, 0.0)) - gas_at(v_uv - vec2(reach.x, 0.0)),
                      gas_at(v_uv + vec2(0.0, reach.y)) - gas_at(v_uv - vec2(0.0, reach.y)));
    // light is bent towards where there is less of it, since hot gas is thin
    o_colour = texture(u_scene, v_uv - u_haze * slope / (2.0 * kReach * u_pixels));
}
