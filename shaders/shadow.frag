// The sheets as the lamp sees them.
// in  distance along the lamp's light, 0 .. 1
// out 1, the distance and its square, to be blurred into a share, a mean and a variance

in float v_distance;
out vec4 o_moments;

void main() { o_moments = vec4(1.0, v_distance, v_distance * v_distance, 1.0); }
