// Follows studio_scatter.glsl.
//
// Maps the unit cube into the deformation cage and computes the light that matt surfaces scatter,
// which changes so slowly that once a vertex is enough.
layout(location = 0) in vec3 unitPosition;  // Spine to fore edge, foot to head, back to front.
layout(location = 1) in vec3 unitNormal;    // A covector of the same cube.
layout(location = 2) in vec2 vertexTexCoord;
layout(location = 3) in float vertexSkyVisibility;  // Share of the surroundings visible from here.
layout(location = 4) in float vertexSurfaceId;  // Number of the smooth side the vertex belongs to.
layout(location = 5) in vec3 vertexAway;  // Covector away from what hides the surroundings.
layout(location = 6) in vec3 rolledOut;  // Position in the picture of strips; z is 0 elsewhere.

uniform vec3 cage[8];  // World; bit 0 of the index is x, bit 1 y, bit 2 z. [m]
uniform mat4 clipFromWorld;
uniform vec3 beside;  // Share of light that is scattered by what hides the surroundings.
uniform vec3 eye;  // World. [m]
uniform vec3 baseColour;  // This and the next three are surface.frag's.
uniform vec2 metalAndRoughness;  // Factors.
uniform vec3 grainsAcross;       // Grains along the unit cube's axes; 0 for no grain.
uniform vec2 contrastAndRelief;  // Of the grain; relief [m].

out vec2 texCoord;
out vec3 diffuseLight;   // Irradiance / pi. Linear.
out vec3 fromEye;  // World. [m]
out vec3 worldNormal;
out vec3 cubePosition;  // In the unit cube.
out float skyVisibility;
// Software rasterisers read a uniform in each pixel anew, which takes as long as 25 multiplications.
flat out vec3 besideIt;  // beside
flat out vec3 base;  // And so on.
flat out vec2 metalRough;
flat out vec3 grains;
flat out vec2 grainDepth;
flat out float surfaceId;

const float kLean = 1.28;  // Toward the middle of half the surroundings, where half is hidden.

void main() {
  // Interpolate the cage trilinearly: its four edges along x, then two lines along y, then z
  float x = unitPosition.x, y = unitPosition.y, z = unitPosition.z;
  vec3 edge00 = mix(cage[0], cage[1], x), edge10 = mix(cage[2], cage[3], x);
  vec3 edge01 = mix(cage[4], cage[5], x), edge11 = mix(cage[6], cage[7], x);
  vec3 back = mix(edge00, edge10, y), front = mix(edge01, edge11, y);
  vec3 worldPosition = mix(back, front, z);

  // Map the normal by the cofactors of the map's derivatives along the cube's axes
  vec3 alongX = mix(mix(cage[1] - cage[0], cage[3] - cage[2], y),
                    mix(cage[5] - cage[4], cage[7] - cage[6], y), z);
  vec3 alongY = mix(edge10 - edge00, edge11 - edge01, z);
  vec3 alongZ = front - back;
  mat3 cofactors = mat3(cross(alongY, alongZ), cross(alongZ, alongX), cross(alongX, alongY));
  // Light the visible side of an inside-out book
  if (dot(alongX, cofactors[0]) < 0.0) cofactors = -cofactors;
  vec3 normal = normalize(cofactors * unitNormal);

  texCoord = vertexTexCoord;
  fromEye = worldPosition - eye;
  besideIt = beside;
  base = baseColour;
  metalRough = metalAndRoughness;
  grains = grainsAcross;
  grainDepth = contrastAndRelief;
  worldNormal = normal;
  cubePosition = unitPosition;
  skyVisibility = vertexSkyVisibility;
  surfaceId = vertexSurfaceId;
  if (vertexSkyVisibility == 1.0) {
    diffuseLight = scatteredLight(normal);
  } else {
    // Light from what is seen, and from what hides the rest, which faces away
    vec3 away = cofactors * vertexAway;
    away *= inversesqrt(max(dot(away, away), 1e-30));
    vec3 seen = normalize(normal + kLean * length(vertexAway) * away);
    diffuseLight = mix(beside * scatteredLight(away), scatteredLight(seen), vertexSkyVisibility);
  }
  gl_Position = rolledOut.z > 0.0 ? vec4(rolledOut.xy, 0.0, 1.0)
                                  : clipFromWorld * vec4(worldPosition, 1.0);
}
