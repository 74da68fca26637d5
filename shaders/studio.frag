#version 330 core
// A quiet, dark studio wall: brightest behind the book. Drawn once a clip.
in vec2 position;

uniform int supersample;  // Pixels drawn across and down for each pixel of the picture.

out vec4 colour;  // Encoded as sRGB.

const vec3 kMiddle = vec3(0.2196, 0.2353, 0.2588);
const vec3 kEdge = vec3(0.0980, 0.1059, 0.1255);

// Returns an ordered-dither offset for a column, as a share of one 8-bit step, -1/2 to 1/2. Without
// it, so slow a gradient shows bands. It varies by column alone, which costs little in a PNG, whose
// rows are stored as differences.
float ditherOffset(int column) {
  int rank = ((column & 1) << 2) | (column & 2) | ((column & 4) >> 2);
  return (float(rank) + 0.5) / 8.0 - 0.5;
}

void main() {
  float distanceFromMiddle = length(position * vec2(0.62, 0.80) - vec2(0.0, -0.10));
  vec3 wall = mix(kMiddle, kEdge, smoothstep(0.0, 1.35, distanceFromMiddle));
  colour = vec4(wall + ditherOffset(int(gl_FragCoord.x) / supersample) / 255.0, 1.0);
}
