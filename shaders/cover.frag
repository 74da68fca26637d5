// Follows studio_shine.glsl.
//
// Cloth with gold stamping in a photographer's studio. Radiance is linear.
in vec2 texCoord;
in vec3 diffuseLight;
in vec3 fromEye;
in vec3 worldNormal;
in float skyVisibility;
flat in vec3 besideIt;
flat in float stamped;
flat in float surfaceId;

uniform sampler2D albedo;

out vec4 colour;  // Encoded as sRGB; alpha: surfaceId / 255.

vec3 pixelColour(vec3 radiance);

const float kClothRoughness = 0.45;
const float kGoldRoughness = 0.26;
const float kMinViewCosine = 0.05;
const float kStampDepth = 1.2e-4;  // Depth of the gold in the cloth. [m]

// Returns how golden a colour is, 0 to 1: gold has much less blue than red, and much green.
float goldness(vec3 base) {
  return clamp(4.0 * (base.g - 0.35 * base.r), 0.0, 1.0) *
         clamp(6.0 * (0.5 * base.r - base.b), 0.0, 1.0);
}

void main() {
  vec3 base = texture(albedo, texCoord).rgb;
  float gold = stamped * goldness(base);
  vec3 toEye = normalize(-fromEye);
  vec3 normal = bumpedNormal(fromEye, normalize(worldNormal), -kStampDepth * gold);
  // An interpolated normal may point away from the eye where the side hardly does.
  float nv = clamp(dot(normal, toEye), kMinViewCosine, 1.0);
  float cloth = widenedRoughness(kClothRoughness, worldNormal);
  float roughness = mix(cloth, kGoldRoughness, gold);
  vec3 mirrored = reflect(-toEye, normal);
  // A side beside the leaves shows them, seen from most places.
  float seen = skyVisibility * skyVisibility;
  vec3 light = mix(1.4 * besideIt * diffuseLight, studio(mirrored, normal, roughness), seen);
  vec3 share = metalShare(base, kGoldRoughness, nv);
  share = mix(vec3(dielectricShare(cloth, nv)), share, gold);
  vec3 radiance = (1.0 - gold) * base * diffuseLight + light * share;
  colour = vec4(pixelColour(radiance), surfaceId / 255.0);
}
