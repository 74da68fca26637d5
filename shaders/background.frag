#version 330 core
// A quiet, dark studio wall: brightest behind the book. Colours are linear.
in vec2 place;

out vec4 colour;

const vec3 kMiddle = vec3(0.0395, 0.0452, 0.0545);
const vec3 kEdge = vec3(0.0100, 0.0116, 0.0152);

void main() {
  float distanceFromMiddle = length(place * vec2(0.62, 0.80) - vec2(0.0, -0.10));
  colour = vec4(mix(kMiddle, kEdge, smoothstep(0.0, 1.35, distanceFromMiddle)), 1.0);
}
