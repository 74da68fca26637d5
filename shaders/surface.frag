// Follows studio_shine.glsl.
//
// Any material of the metallic-roughness model of glTF 2.0 in a photographer's studio. Radiance is
// linear.
in vec2 texCoord;
in vec3 diffuseLight;
in vec3 fromEye;
in vec3 worldNormal;
in vec3 cubePosition;
in float skyVisibility;
flat in vec3 base;
flat in vec2 metalRough;
flat in vec3 grains;
flat in vec2 grainDepth;
flat in float surfaceId;

uniform sampler2D albedo;
uniform sampler2D metalRoughness;  // Green: roughness, blue: metalness.

out vec4 colour;  // Encoded as sRGB; alpha: surfaceId / 255.

vec3 pixelColour(vec3 radiance);

const float kMinViewCosine = 0.05;
const float kMinRoughness = 0.05;

// Returns a number from 0 to 1 that follows from a grain's place.
float randomOf(ivec3 cell) {
  uint hash = uint(cell.x) * 0x8da6b343u ^ uint(cell.y) * 0xd8163841u ^ uint(cell.z) * 0xcb1ab31fu;
  hash = (hash ^ (hash >> 15)) * 0x2c1b3c6du;
  hash = (hash ^ (hash >> 12)) * 0x297a2d39u;
  return float(hash >> 8) / 16777216.0;
}

// Returns value noise from -1 to 1, which varies within a length of 1.
float noiseAt(vec3 position) {
  vec3 low = floor(position), inside = position - low;
  ivec3 cell = ivec3(low);
  vec3 t = inside * inside * (3.0 - 2.0 * inside);
  vec4 along;
  for (int i = 0; i < 4; ++i) {
    ivec3 corner = cell + ivec3(0, i & 1, i >> 1);
    along[i] = mix(randomOf(corner), randomOf(corner + ivec3(1, 0, 0)), t.x);
  }
  return 2.0 * mix(mix(along.x, along.y, t.y), mix(along.z, along.w, t.y), t.z) - 1.0;
}

// Returns the grain at a place, -1 to 1, of two sizes; each fades where it is finer than pixels.
float grainAt(vec3 place) {
  vec3 reach = fwidth(place);
  float finest = max(reach.x, max(reach.y, reach.z));
  float coarse = noiseAt(place) * clamp(1.5 - 1.5 * finest, 0.0, 1.0);
  float fine = noiseAt(2.3 * place + 17.0) * clamp(1.5 - 3.5 * finest, 0.0, 1.0);
  return 0.65 * coarse + 0.35 * fine;
}

void main() {
  vec3 painted = base * texture(albedo, texCoord).rgb;
  vec4 measured = texture(metalRoughness, texCoord);
  float metal = metalRough.x * measured.b;
  float rough = max(metalRough.y * measured.g, kMinRoughness);
  vec3 normal = normalize(worldNormal);
  if (grains.x > 0.0) {
    float grain = grainAt(grains * cubePosition);
    painted *= 1.0 + grainDepth.x * grain;
    normal = bumpedNormal(fromEye, normal, grainDepth.y * grain);
  }
  vec3 toEye = normalize(-fromEye);
  // An interpolated normal may point away from the eye where the side hardly does.
  float nv = clamp(dot(normal, toEye), kMinViewCosine, 1.0);
  rough = widenedRoughness(rough, worldNormal);
  vec3 share = metalShare(metal, metal * painted, rough, nv);
  share += (1.0 - metal) * dielectricShare(rough, nv);
  float lobe = rough * mix(kDielectricLobe, 1.0, metal);
  vec3 shine = studio(reflect(-toEye, normal), normal, lobe) * share;
  vec3 radiance = (1.0 - metal) * painted * diffuseLight + skyVisibility * shine;
  colour = vec4(pixelColour(radiance), surfaceId / 255.0);
}
