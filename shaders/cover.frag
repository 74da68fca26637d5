// Follows studio_shine.glsl.
//
// Cloth with gold stamping in a photographer's studio. Radiance is linear.
in vec2 texCoord;
in vec3 diffuseLight;
in vec3 fromEye;
in vec3 worldNormal;
in float skyVisibility;
flat in vec3 besideIt;
flat in float surfaceId;

uniform sampler2D albedo;  // Alpha: share that isn't gold.

out vec4 colour;  // Encoded as sRGB; alpha: surfaceId / 255.

vec3 pixelColour(vec3 radiance);

const float kClothRoughness = 0.45;
const float kGoldRoughness = 0.26;
const float kMinViewCosine = 0.05;
const vec3 kFoil = vec3(0.72, 0.44, 0.11);  // The gold's colour, where it is brightest.

void main() {
  vec4 printed = texture(albedo, texCoord);
  vec3 base = printed.rgb;
  float gold = 1.0 - printed.a;
  // Tell the gold's colour from that of the cloth beside it.
  vec3 golden = min(base, gold * kFoil);
  vec3 toEye = normalize(-fromEye);
  vec3 normal = normalize(worldNormal);
  // An interpolated normal may point away from the eye where the side hardly does.
  float nv = clamp(dot(normal, toEye), kMinViewCosine, 1.0);
  float cloth = widenedRoughness(kClothRoughness, worldNormal);
  float roughness = mix(kDielectricLobe * cloth, kGoldRoughness, gold);
  vec3 mirrored = reflect(-toEye, normal);
  // A side beside the leaves shows them, seen from most places.
  float seen = skyVisibility * skyVisibility;
  vec3 light = mix(1.4 * besideIt * diffuseLight, studio(mirrored, normal, roughness), seen);
  vec3 share = metalShare(gold, golden, kGoldRoughness, nv);
  share += (1.0 - gold) * dielectricShare(cloth, nv);
  vec3 radiance = (base - golden) * diffuseLight + light * share;
  colour = vec4(pixelColour(radiance), surfaceId / 255.0);
}
