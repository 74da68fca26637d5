// Follows studio_lights.glsl.
//
// Cloth with gold stamping in a photographer's studio. Radiance is linear; the frame buffer encodes
// sRGB.
in vec2 texCoord;
in vec3 diffuseLight;
in vec3 worldPosition;
in vec3 worldNormal;
in float skyVisibility;
flat in float surfaceId;

uniform sampler2D albedo;
uniform vec3 eye;  // World. [m]
uniform int plainCloth;  // 1 for cloth in which no gold is stamped, else 0.

out vec4 colour;  // Alpha: surfaceId / 255.

vec3 toneMap(vec3 radiance);

const float kClothRoughness = 0.45;
const float kGoldRoughness = 0.26;
const float kClothSheen = 0.9;  // Factor of keyHighlight().
const float kClothReflectance = 0.04;
const float kMinViewCosine = 0.25;  // Fibres keep cloth from mirroring more at grazing angles.
const float kMaxSpread = 0.5;  // Greatest increase of the squared GGX width.
const float kStampDepth = 1.2e-4;  // Depth of the gold in the cloth. [m]

// Two softboxes in front and a strip light behind: radiance, and half width and half height as
// tangents of angles.
const vec3 kKeyRadiance = vec3(3.3, 3.05, 2.7);
const vec3 kFillRadiance = vec3(1.1, 1.35, 1.8);
const vec3 kRimRadiance = vec3(1.3, 1.45, 1.65);
const vec2 kKeySize = vec2(0.50, 0.40);
const vec2 kFillSize = vec2(0.22, 0.80);
const vec2 kRimSize = vec2(1.10, 0.22);

// Returns how golden a colour is, 0 to 1: gold has much less blue than red, and much green.
float goldness(vec3 base) {
  return clamp(4.0 * (base.g - 0.35 * base.r), 0.0, 1.0) *
         clamp(6.0 * (0.5 * base.r - base.b), 0.0, 1.0);
}

// Returns the normal of a surface whose height changes from pixel to pixel (Mikkelsen, "Bump
// Mapping Unparametrized Surfaces on the GPU", 2010).
vec3 bumpedNormal(vec3 normal, float height) {
  vec3 acrossX = dFdx(worldPosition), acrossY = dFdy(worldPosition);
  vec3 alongX = cross(acrossY, normal), alongY = cross(normal, acrossX);
  float area = dot(acrossX, alongX);
  vec3 gradient = sign(area) * (dFdx(height) * alongX + dFdy(height) * alongY);
  // A strip drawn as a line has no neighbours across it: its area is 0.
  return normalize(max(abs(area), 1e-15) * normal - gradient);
}

// Returns the share of a lobe of this width about `mirrored` that a softbox fills.
float filledShare(vec3 mirrored, vec3 direction, vec2 halfSize, float width) {
  vec3 side = normalize(vec3(direction.z, 0.0, -direction.x));
  vec3 up = cross(direction, side);
  float ahead = dot(mirrored, direction);
  vec2 position = vec2(dot(mirrored, side), dot(mirrored, up)) / max(ahead, 0.05);
  vec2 inside = clamp((halfSize - abs(position)) / width + 0.5, 0.0, 1.0);
  // A small box can't fill a wide lobe.
  vec2 maxShare = min(2.0 * halfSize / width, 1.0);
  return ahead > 0.0 ? inside.x * inside.y * maxShare.x * maxShare.y : 0.0;
}

// Returns the studio's radiance, averaged over the GGX lobe, whose width grows with roughness
// squared.
vec3 studio(vec3 mirrored, float roughness) {
  float width = 2.6 * roughness * roughness + 0.02;
  float height = smoothstep(-0.5 - width, 0.7 + width, mirrored.y);
  vec3 light = mix(vec3(0.34, 0.30, 0.27), vec3(0.64, 0.66, 0.70), height);
  light += vec3(0.90, 0.86, 0.80) * smoothstep(0.1, 1.0, mirrored.z);  // The photographer's wall.
  light += kKeyRadiance * filledShare(mirrored, kKeyDirection, kKeySize, width);
  light += kFillRadiance * filledShare(mirrored, kFillDirection, kFillSize, width);
  return light + kRimRadiance * filledShare(mirrored, kRimDirection, kRimSize, width);
}

// Returns the share of the key light, taken as a point, that a rough dielectric reflects to the
// eye (GGX distribution and visibility, Schlick's Fresnel). Has the long tail that studio()'s
// narrow lobe lacks.
float keyHighlight(vec3 normal, vec3 toEye, float nv, float roughness) {
  vec3 halfway = normalize(toEye + kKeyDirection);
  float nh = max(dot(normal, halfway), 0.0), nl = max(dot(normal, kKeyDirection), 0.0);
  float vh = max(dot(toEye, halfway), 0.0);
  float a2 = roughness * roughness * roughness * roughness;
  float d = nh * nh * (a2 - 1.0) + 1.0;
  float k = 0.5 * roughness * roughness;
  float visibility = 0.25 / ((nl * (1.0 - k) + k) * (nv * (1.0 - k) + k));
  float miss = 1.0 - vh, miss2 = miss * miss;
  float fresnel = kClothReflectance + (1.0 - kClothReflectance) * miss2 * miss2 * miss;
  return a2 / (d * d) * visibility * fresnel * nl;
}

// Returns the share of the studio's radiance that is mirrored (Karis, "Physically Based Shading on
// Mobile", 2014).
vec3 mirroredShare(vec3 reflectance, float roughness, float nv) {
  vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
  float a = min(r.x * r.x, exp2(-9.28 * nv)) * r.x + r.y;
  vec2 ab = vec2(-1.04, 1.04) * a + r.zw;
  return reflectance * ab.x + ab.y;
}

// Returns the roughness whose lobe is as wide as that of all the pixel's normals together
// (Tokuyoshi and Kaplanyan, "Improved Geometric Specular Antialiasing", 2019).
float widenedRoughness(float roughness, vec3 normal) {
  vec3 x = dFdx(normal), y = dFdy(normal);
  float spread = min(0.12 * (dot(x, x) + dot(y, y)), kMaxSpread);
  float a = roughness * roughness;
  return sqrt(sqrt(a * a + spread));
}

void main() {
  vec3 base = texture(albedo, texCoord).rgb;
  float gold = float(1 - plainCloth) * goldness(base);
  vec3 toEye = normalize(eye - worldPosition);
  vec3 normal = bumpedNormal(normalize(worldNormal), -kStampDepth * gold);
  // An interpolated normal may point away from the eye where the side hardly does.
  float nv = clamp(dot(normal, toEye), kMinViewCosine, 1.0);
  float cloth = widenedRoughness(kClothRoughness, worldNormal);
  float roughness = mix(cloth, kGoldRoughness, gold);
  vec3 reflectance = mix(vec3(kClothReflectance), base, gold);
  vec3 mirrored = reflect(-toEye, normal);
  vec3 shine = studio(mirrored, roughness) * mirroredShare(reflectance, roughness, nv);
  shine += (1.0 - gold) * kClothSheen * keyHighlight(normal, toEye, nv, cloth);
  vec3 radiance = (1.0 - 0.65 * gold) * base * diffuseLight + skyVisibility * shine;
  colour = vec4(toneMap(radiance), surfaceId / 255.0);
}
