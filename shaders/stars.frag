#version 330 core
// A night sky, identical in all pictures of one size. Drawn once a clip, or, where the camera turns,
// in each picture.
in vec2 position;

uniform vec2 pictureSize;  // [pixels]
uniform mat4 skyFromPicture;  // Of a camera that turns: (position, 1, 1) to a direction; else 0.

out vec4 colour;  // Encoded as sRGB.

const vec3 kSky = vec3(0.020, 0.023, 0.036);
const float kCells = 26.0;      // Cells per half of the shorter side; at most one star each.
const float kSkyCells = 96.0;  // In a sky that turns: along half the edge of a cube around it.
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
  float square = magnitude * magnitude;
  float fifth = square * square * magnitude;  // pow() takes twice as long.
  float brightness = 0.14 + 0.86 * fifth;
  float radius = max(0.022 + 0.03 * fifth * square, 0.6 * pixel);
  vec2 offset = point - vec2(cell) - 0.15 - 0.7 * random.yz;
  vec3 tint = mix(vec3(1.0, 0.86, 0.70), vec3(0.75, 0.86, 1.0), random.w);
  return tint * brightness * exp(-dot(offset, offset) / (radius * radius));
}

// Returns the place of a direction on the unfolded sides of a cube. [cells]
vec2 onCube(vec3 direction) {
  vec3 size = abs(direction);
  int axis = size.x > max(size.y, size.z) ? 0 : size.y > size.z ? 1 : 2;
  float side = float(2 * axis) + (direction[axis] > 0.0 ? 1.0 : 0.0);
  vec2 place = vec2(direction[(axis + 1) % 3], direction[(axis + 2) % 3]) / size[axis];
  return kSkyCells * (place + vec2(4.0 * side, 0.0));
}

void main() {
  vec2 point = position * kCells;
  float pixel = 2.0 * kCells / min(pictureSize.x, pictureSize.y);
  if (skyFromPicture[3][3] != 0.0) {
    vec3 direction = mat3(skyFromPicture) * vec3(position, 1.0);
    pixel *= kSkyCells / kCells * length(mat3(skyFromPicture)[1]) / length(direction);
    point = onCube(direction);
  }
  // A star is 0.15 or more within its cell, where its light ends: 2.5 of its radii in pictures of 520
  // rows, a pixel in those of 350. To look in four cells took a fifth of a picture's time.
  colour = vec4(kSky + star(ivec2(floor(point)), point, pixel), 1.0);
}
