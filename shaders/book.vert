#version 330 core
// Maps the unit cube into the book's eight corners, deformed or not.
layout(location = 0) in vec3 unitPlace;   // Spine to fore edge, foot to head, back to front.
layout(location = 1) in vec3 unitNormal;  // Along one axis of the same cube.
layout(location = 2) in vec2 textureCoordinates;
layout(location = 3) in float openness;

uniform vec3 corners[8];     // World; bit 0 of the index is x, bit 1 y, bit 2 z. [m]
uniform mat4 clipFromWorld;

out vec3 worldPlace;
out vec3 worldNormal;
out vec2 texturePlace;
out float skyShare;

void main() {
  float x = unitPlace.x, y = unitPlace.y, z = unitPlace.z;
  // The four edges along x, then the two faces' lines along y: trilinear interpolation.
  vec3 edge00 = mix(corners[0], corners[1], x), edge10 = mix(corners[2], corners[3], x);
  vec3 edge01 = mix(corners[4], corners[5], x), edge11 = mix(corners[6], corners[7], x);
  vec3 back = mix(edge00, edge10, y), front = mix(edge01, edge11, y);
  worldPlace = mix(back, front, z);

  // Its derivatives along the cube's axes; a normal maps by their cofactors.
  vec3 alongX = mix(mix(corners[1] - corners[0], corners[3] - corners[2], y),
                    mix(corners[5] - corners[4], corners[7] - corners[6], y), z);
  vec3 alongY = mix(edge10 - edge00, edge11 - edge01, z);
  vec3 alongZ = front - back;
  worldNormal = unitNormal.x * cross(alongY, alongZ) + unitNormal.y * cross(alongZ, alongX) +
                unitNormal.z * cross(alongX, alongY);

  texturePlace = textureCoordinates;
  skyShare = openness;
  gl_Position = clipFromWorld * vec4(worldPlace, 1.0);
}
