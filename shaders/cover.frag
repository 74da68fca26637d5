// After studio_lights.glsl.
//
// Cloth with gold stamping in a photographer's studio. Radiance is linear; the frame buffer encodes
// sRGB.
in vec2 texCoord;
in vec3 diffuseLight;
in vec3 worldPlace;
in vec3 worldNormal;
in float visibility;
flat in float onSurface;

uniform sampler2D albedo;
uniform vec3 eye;  // World. [m]

out vec4 colour;  // Alpha: the number of the surface, of 255.

vec3 toneMap(vec3 radiance);

const float kClothRoughness = 0.45;
const float kGoldRoughness = 0.26;
const float kClothSheen = 0.9;     // Of keyHighlight().
const float kClothReflectance = 0.04;
const float kMaxGrazing = 0.25;    // Cosine; fibres keep cloth from mirroring more.
const float kMaxSpread = 0.5;  // Of squared GGX widths.
const float kStampDepth = 1.2e-4;  // How deep gold lies in the cloth. [m]

// Two softboxes and a strip behind: radiance, half width and half height as tangents.
const vec3 kKeyRadiance = vec3(3.3, 3.05, 2.7);
const vec3 kFillRadiance = vec3(1.1, 1.35, 1.8);
const vec3 kRimRadiance = vec3(1.3, 1.45, 1.65);
const vec2 kKeySize = vec2(0.50, 0.40);
const vec2 kFillSize = vec2(0.22, 0.80);
const vec2 kRimSize = vec2(1.10, 0.22);

// How far a colour is that of gold: much less blue than green, much green beside the red.
float goldness(vec3 surface) {
  return clamp(4.0 * (surface.g - 0.35 * surface.r), 0.0, 1.0) *
         clamp(6.0 * (0.5 * surface.r - surface.b), 0.0, 1.0);
}

// The normal of a surface whose height changes from pixel to pixel (Mikkelsen, "Bump Mapping
// Unparametrized Surfaces on the GPU", 2010).
vec3 bent(vec3 normal, float height) {
  vec3 acrossX = dFdx(worldPlace), acrossY = dFdy(worldPlace);
  vec3 alongX = cross(acrossY, normal), alongY = cross(normal, acrossX);
  float area = dot(acrossX, alongX);
  vec3 gradient = sign(area) * (dFdx(height) * alongX + dFdy(height) * alongY);
  // Along the line that a strip is drawn as, nothing is known of what is beside it.
  return normalize(max(abs(area), 1e-15) * normal - gradient);
}

// How much of a lobe of this width about `mirrored` a softbox fills.
float shareOf(vec3 mirrored, vec3 direction, vec2 halfSize, float width) {
  vec3 side = normalize(vec3(direction.z, 0.0, -direction.x));
  vec3 up = cross(direction, side);
  float ahead = dot(mirrored, direction);
  vec2 place = vec2(dot(mirrored, side), dot(mirrored, up)) / max(ahead, 0.05);
  vec2 inside = clamp((halfSize - abs(place)) / width + 0.5, 0.0, 1.0);
  // A wide lobe isn't filled by a small box.
  vec2 most = min(2.0 * halfSize / width, 1.0);
  return ahead > 0.0 ? inside.x * inside.y * most.x * most.y : 0.0;
}

// Radiance of the studio, averaged over GGX's lobe, whose width goes with roughness squared.
vec3 studio(vec3 mirrored, float roughness) {
  float width = 2.6 * roughness * roughness + 0.02;
  float height = smoothstep(-0.5 - width, 0.7 + width, mirrored.y);
  vec3 light = mix(vec3(0.34, 0.30, 0.27), vec3(0.64, 0.66, 0.70), height);
  light += vec3(0.90, 0.86, 0.80) * smoothstep(0.1, 1.0, mirrored.z);  // The photographer's wall.
  light += kKeyRadiance * shareOf(mirrored, kKeyDirection, kKeySize, width);
  light += kFillRadiance * shareOf(mirrored, kFillDirection, kFillSize, width);
  return light + kRimRadiance * shareOf(mirrored, kRimDirection, kRimSize, width);
}

// GGX's distribution and visibility, Schlick's Fresnel: what a rough dielectric throws to the eye of
// the key light taken as a point, with the long tail that studio()'s narrow lobe doesn't have.
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

// The part of the studio that is mirrored (Karis, "Physically Based Shading on Mobile", 2014).
vec3 mirroredShare(vec3 reflectance, float roughness, float nv) {
  vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
  float a = min(r.x * r.x, exp2(-9.28 * nv)) * r.x + r.y;
  vec2 ab = vec2(-1.04, 1.04) * a + r.zw;
  return reflectance * ab.x + ab.y;
}

// Roughness that mirrors as widely as the pixel's normals together do (Tokuyoshi and Kaplanyan,
// "Improved Geometric Specular Antialiasing", 2019).
float widened(float roughness, vec3 normal) {
  vec3 x = dFdx(normal), y = dFdy(normal);
  float spread = min(0.12 * (dot(x, x) + dot(y, y)), kMaxSpread);
  float a = roughness * roughness;
  return sqrt(sqrt(a * a + spread));
}

void main() {
  vec3 surface = texture(albedo, texCoord).rgb;
  float gold = goldness(surface);
  vec3 toEye = normalize(eye - worldPlace);
  vec3 normal = bent(normalize(worldNormal), -kStampDepth * gold);
  // Between vertices the normal may turn away from the eye where the side hardly does.
  float nv = clamp(dot(normal, toEye), kMaxGrazing, 1.0);
  float cloth = widened(kClothRoughness, worldNormal);
  float roughness = mix(cloth, kGoldRoughness, gold);
  vec3 reflectance = mix(vec3(kClothReflectance), surface, gold);
  vec3 mirrored = reflect(-toEye, normal);
  vec3 shine = studio(mirrored, roughness) * mirroredShare(reflectance, roughness, nv);
  shine += (1.0 - gold) * kClothSheen * keyHighlight(normal, toEye, nv, cloth);
  vec3 radiance = (1.0 - 0.65 * gold) * surface * diffuseLight + visibility * shine;
  colour = vec4(toneMap(radiance), onSurface / 255.0);
}
