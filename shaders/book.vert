// After studio_lights.glsl.
//
// Maps the unit cube into the book's eight corners, deformed or not, and gathers the light that
// matt surfaces scatter, which changes so slowly that the vertices are enough.
layout(location = 0) in vec3 unitPosition;   // Spine to fore edge, foot to head, back to front.
layout(location = 1) in vec3 unitNormal;  // A covector of the same cube.
layout(location = 2) in vec2 textureCoordinates;
layout(location = 3) in float skyVisibility;   // Share of the surroundings that is seen from here.
layout(location = 4) in float surface;    // Number of the smooth side that this is a point of.
layout(location = 5) in vec3 rolledOut;   // Place in the picture of strips; z is 0 elsewhere.

uniform vec3 corners[8];  // World; bit 0 of the index is x, bit 1 y, bit 2 z. [m]
uniform mat4 clipFromWorld;

out vec2 texCoord;
out vec3 diffuseLight;     // Irradiance / pi. Linear.
out vec3 worldPlace;   // [m]
out vec3 worldNormal;
out float visibility;        // skyVisibility
flat out float onSurface;

// The studio of cover.frag as a matt surface sees it: each light's irradiance / pi.
const vec3 kKeyColour = vec3(1.02, 0.95, 0.85);
const vec3 kFillColour = vec3(0.36, 0.42, 0.52);
const vec3 kRimColour = vec3(0.36, 0.40, 0.46);
const vec3 kWallColour = vec3(0.30, 0.29, 0.275);  // The lit wall behind the camera.
const vec3 kSky = vec3(0.28, 0.29, 0.32);
const vec3 kGround = vec3(0.19, 0.175, 0.165);

vec3 irradiance(vec3 normal) {
  vec3 light = mix(kGround, kSky, 0.5 + 0.5 * normal.y);
  light += kWallColour * max(normal.z, 0.0);
  light += kKeyColour * max(dot(normal, kKeyDirection), 0.0);
  light += kFillColour * max(dot(normal, kFillDirection), 0.0);
  return light + kRimColour * max(dot(normal, kRimDirection), 0.0);
}

void main() {
  float x = unitPosition.x, y = unitPosition.y, z = unitPosition.z;
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
  vec3 normal = normalize(unitNormal.x * cross(alongY, alongZ) +
                          unitNormal.y * cross(alongZ, alongX) +
                          unitNormal.z * cross(alongX, alongY));
  // Of an inside-out book the side that is seen is lit.
  if (dot(alongX, cross(alongY, alongZ)) < 0.0) normal = -normal;

  texCoord = textureCoordinates;
  worldNormal = normal;
  visibility = skyVisibility;
  onSurface = surface;
  diffuseLight = irradiance(normal) * skyVisibility;
  gl_Position = rolledOut.z > 0.0 ? vec4(rolledOut.xy, 0.0, 1.0)
                                  : clipFromWorld * vec4(worldPlace, 1.0);
}
