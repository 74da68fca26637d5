#version 330 core
// A quiet, dark studio wall: brightest behind the book. Drawn once a clip, or, where
// the camera turns, in each picture.
in vec2 position;

uniform vec2 pictureSize;  // [pixels]
uniform int supersample;   // Pixels drawn across and down for each pixel of the picture.
uniform mat4 skyFromPicture;  // Of a camera that turns: (position, 1, 1) to a direction; else 0.

out vec4 colour;  // Encoded as sRGB.

const vec3 kEdge = vec3(25.0, 28.0, 34.0) / 255.0;
// The same in each colour, so that all three change at the same pixels: a third as many bytes in a PNG.
const float kBrighter = 31.0 / 255.0;  // In the middle.
const float kPatches = 7.0;   // Of a wall that turns: patches in a radian.
const float kContrast = 0.3;  // Of their light.

// Returns an ordered-dither offset for a row, as a share of one 8-bit step, -1/2 to 1/2. Without
// it, so slow a gradient shows bands. It varies by row alone, which costs little in a PNG, whose
// pixels are stored as differences to the left.
float ditherOffset(int row) {
  int rank = ((row & 1) << 2) | (row & 2) | ((row & 4) >> 2);
  return (float(rank) + 0.5) / 8.0 - 0.5;
}

// Returns a pseudorandom number from 0 to 1 (Jarzynski and Olano, 2020: pcg3d).
float random(ivec3 cell) {
  uvec3 v = uvec3(cell) * 1664525u + 1013904223u;
  v.x += v.y * v.z; v.y += v.z * v.x; v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  return float(v.x >> 8u) / 16777216.0;
}

// Returns how bright the plaster of a wall is in a direction, -1 to 1: the mean of random numbers
// at the corners around it.
float plaster(vec3 direction) {
  vec3 place = kPatches * normalize(direction), low = floor(place);
  vec3 share = smoothstep(0.0, 1.0, place - low);
  float light = 0.0;
  for (int i = 0; i < 8; ++i) {
    ivec3 corner = ivec3(i & 1, (i >> 1) & 1, i >> 2);
    vec3 near = mix(1.0 - share, share, vec3(corner));
    light += near.x * near.y * near.z * random(ivec3(low) + corner);
  }
  return 2.0 * light - 1.0;
}

void main() {
  float distanceFromMiddle = length(position * vec2(0.62, 0.80) - vec2(0.0, -0.10));
  vec3 wall = kEdge + kBrighter * (1.0 - smoothstep(0.0, 1.35, distanceFromMiddle));
  if (skyFromPicture[3][3] != 0.0)
    wall *= 1.0 + kContrast * plaster(mat3(skyFromPicture) * vec3(position, 1.0));
  int row = int(gl_FragCoord.y);
#ifdef CLIP_Y_UP  // In a browser the frame buffer's first row is the lowest.
  row = int(pictureSize.y) - 1 - row;
#endif
  colour = vec4(wall + ditherOffset(row / supersample) / 255.0, 1.0);
}
