#version 330 core
// A night sky, the same in every picture of a size. Drawn once a clip.
in vec2 place;

uniform vec2 pictureSize;  // [pixels]

out vec4 colour;  // sRGB, written as it is.

const vec3 kSky = vec3(0.020, 0.023, 0.036);
const float kCells = 26.0;      // Per half height; at most one star each.
const float kStarShare = 0.45;  // Of the cells.

// Four numbers from 0 to 1 that look random, the same on every machine (Jarzynski and Olano, "Hash
// Functions for GPU Rendering", 2020: pcg4d).
vec4 chance(ivec2 cell) {
  uvec4 v = uvec4(cell, cell.x + 7919, cell.y + 104729) * 1664525u + 1013904223u;
  v.x += v.y * v.w; v.y += v.z * v.x; v.z += v.x * v.y; v.w += v.y * v.z;
  v ^= v >> 16u;
  v.x += v.y * v.w; v.y += v.z * v.x; v.z += v.x * v.y; v.w += v.y * v.z;
  return vec4(v >> 8u) / 16777216.0;
}

// Light of the star of a cell: few bright ones, many faint ones, some warm, some cold.
vec3 star(ivec2 cell, vec2 point, float pixel) {
  vec4 random = chance(cell);
  if (random.x > kStarShare) return vec3(0.0);
  float magnitude = random.x / kStarShare;
  float brightness = 0.14 + 0.86 * pow(magnitude, 5.0);
  float radius = max(0.022 + 0.03 * pow(magnitude, 7.0), 0.6 * pixel);
  vec2 away = point - vec2(cell) - 0.15 - 0.7 * random.yz;
  vec3 tint = mix(vec3(1.0, 0.86, 0.70), vec3(0.75, 0.86, 1.0), random.w);
  return tint * brightness * exp(-dot(away, away) / (radius * radius));
}

void main() {
  vec2 point = place * kCells;
  float pixel = 2.0 * kCells / min(pictureSize.x, pictureSize.y);
  vec3 light = kSky;
  ivec2 cell = ivec2(floor(point));
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) light += star(cell + ivec2(x, y), point, pixel);
  }
  colour = vec4(light, 1.0);
}
