#version 330 core
// A night sky, identical in all pictures of one size. Drawn once a clip.
in vec2 position;

uniform vec2 pictureSize;  // [pixels]

out vec4 colour;  // Encoded as sRGB.

const vec3 kSky = vec3(0.020, 0.023, 0.036);
const float kCells = 26.0;      // Cells per half of the shorter side; at most one star each.
const float kStarShare = 0.45;  // Share of the cells that have a star.

// Returns four pseudorandom numbers from 0 to 1, identical on every machine (Jarzynski and Olano,
// "Hash Functions for GPU Rendering", 2020: pcg4d).
vec4 random4(ivec2 cell) {
  uvec4 v = uvec4(cell, cell.x + 7919, cell.y + 104729) * 1664525u + 1013904223u;
  v.x += v.y * v.w; v.y += v.z * v.x; v.z += v.x * v.y; v.w += v.y * v.z;
  v ^= v >> 16u;
  v.x += v.y * v.w; v.y += v.z * v.x; v.z += v.x * v.y; v.w += v.y * v.z;
  return vec4(v >> 8u) / 16777216.0;
}

// Returns the light that a cell's star adds at a point. Few stars are bright and many faint, some
// warm and some cold.
vec3 star(ivec2 cell, vec2 point, float pixel) {
  vec4 random = random4(cell);
  if (random.x > kStarShare) return vec3(0.0);
  float magnitude = random.x / kStarShare;
  float brightness = 0.14 + 0.86 * pow(magnitude, 5.0);
  float radius = max(0.022 + 0.03 * pow(magnitude, 7.0), 0.6 * pixel);
  vec2 offset = point - vec2(cell) - 0.15 - 0.7 * random.yz;
  vec3 tint = mix(vec3(1.0, 0.86, 0.70), vec3(0.75, 0.86, 1.0), random.w);
  return tint * brightness * exp(-dot(offset, offset) / (radius * radius));
}

void main() {
  vec2 point = position * kCells;
  float pixel = 2.0 * kCells / min(pictureSize.x, pictureSize.y);
  vec3 light = kSky;
  ivec2 cell = ivec2(floor(point));
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) light += star(cell + ivec2(x, y), point, pixel);
  }
  colour = vec4(light, 1.0);
}
