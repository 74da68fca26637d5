// Follows studio_scatter.glsl, before cover.frag and surface.frag: what the studio looks like in a
// surface that mirrors it. The light that matt surfaces scatter of it follows from its constants.
const float kMaxSpread = 0.5;  // Greatest increase of the squared GGX width.

const vec3 kBelow = vec3(0.34, 0.30, 0.27);
const vec3 kAbove = vec3(0.64, 0.66, 0.70);
const vec3 kWall = vec3(0.90, 0.86, 0.80);  // The photographer's, which is lit.

// Two softboxes in front and a strip light behind: direction, radiance, and half width and half
// height as tangents of angles.
const vec3 kKeyDirection = vec3(0.4767, 0.5720, 0.6674);
const vec3 kFillDirection = vec3(-0.8452, 0.0528, 0.5317);
const vec3 kRimDirection = vec3(-0.3487, 0.6475, -0.6774);
const vec3 kKeyRadiance = vec3(3.3, 3.05, 2.7);
const vec3 kFillRadiance = vec3(1.1, 1.35, 1.8);
const vec3 kRimRadiance = vec3(1.3, 1.45, 1.65);
const vec2 kKeySize = vec2(0.50, 0.40);
const vec2 kFillSize = vec2(0.22, 0.80);
const vec2 kRimSize = vec2(1.10, 0.22);

// Returns the normal of a surface at `position` (world, from anywhere) whose height changes from pixel to pixel
// (Mikkelsen, "Bump Mapping Unparametrized Surfaces on the GPU", 2010).
vec3 bumpedNormal(vec3 position, vec3 normal, float height) {
  vec3 acrossX = dFdx(position), acrossY = dFdy(position);
  vec3 alongX = cross(acrossY, normal), alongY = cross(normal, acrossX);
  float area = dot(acrossX, alongX);
  vec3 gradient = sign(area) * (dFdx(height) * alongX + dFdy(height) * alongY);
  // A strip drawn as a line has no neighbours across it: its area is 0.
  return normalize(max(abs(area), 1e-15) * normal - gradient);
}

// Returns the share of a lobe of 1 / `sharpness` about `mirrored` that a softbox fills.
float filledShare(vec3 mirrored, vec3 direction, vec2 halfSize, float sharpness) {
  vec3 side = normalize(vec3(direction.z, 0.0, -direction.x));
  vec3 up = cross(direction, side);
  float ahead = dot(mirrored, direction);
  vec2 position = vec2(dot(mirrored, side), dot(mirrored, up)) * (1.0 / max(ahead, 0.05));
  vec2 inside = clamp((halfSize - abs(position)) * sharpness + 0.5, 0.0, 1.0);
  // A small box can't fill a wide lobe.
  vec2 maxShare = min(2.0 * halfSize * sharpness, 1.0);
  return ahead > 0.0 ? inside.x * inside.y * maxShare.x * maxShare.y : 0.0;
}

// Returns the studio's radiance, averaged over the GGX lobe about `mirrored`: a narrow lobe, and a
// long tail that sees what a matt surface scatters. Seen along the normal it is off by 0.08 in the
// mean, at any roughness. At grazing light it is narrower, with less of a tail.
vec3 studio(vec3 mirrored, vec3 normal, float roughness) {
  float a = roughness * roughness;
  float grazing = 0.5 + 0.5 * dot(mirrored, normal);
  float sharpness = 1.0 / (grazing * min(6.0 * a, 0.15 + 1.1 * roughness) + 0.01);
  float height = smoothstep(-0.5 - a, 0.7 + a, mirrored.y);
  vec3 light = mix(kBelow, kAbove, height) + kWall * smoothstep(0.1 - a, 1.0, mirrored.z);
  light += kKeyRadiance * filledShare(mirrored, kKeyDirection, kKeySize, sharpness);
  light += kFillRadiance * filledShare(mirrored, kFillDirection, kFillSize, sharpness);
  light += kRimRadiance * filledShare(mirrored, kRimDirection, kRimSize, sharpness);
  vec3 tail = scatteredLight(normalize(mirrored + normal));
  return mix(light, tail, grazing * smoothstep(0.0, 1.0, roughness));
}

// Returns the share of the studio's radiance that what isn't a metal mirrors: Fresnel's formula for
// glass and fibres, averaged over the GGX lobe, within 7 % in the mean.
float dielectricShare(float roughness, float nv) {
  float r2 = roughness * roughness, miss = 1.0 - nv, miss2 = miss * miss;
  float rise = miss2 * (0.189 + 0.0634 * miss2 * miss) / (0.192 + nv + 4.41 * r2);
  return 0.04 - 0.0275 * r2 * roughness + rise;
}

// Returns the share that a metal mirrors: Schlick's approximation, likewise.
vec3 metalShare(vec3 base, float roughness, float nv) {
  float r2 = roughness * roughness, miss = 1.0 - nv, miss2 = miss * miss;
  float full = 1.0 - r2 * (0.68 - 0.25 * miss);
  return mix(vec3(0.87 / (1.0 + 11.3 * r2) * miss2 * miss2), vec3(full), base);
}

// Returns the roughness whose lobe is as wide as that of all the pixel's normals together
// (Tokuyoshi and Kaplanyan, "Improved Geometric Specular Antialiasing", 2019).
float widenedRoughness(float roughness, vec3 normal) {
  vec3 x = dFdx(normal), y = dFdy(normal);
  float spread = min(0.12 * (dot(x, x) + dot(y, y)), kMaxSpread);
  float a = roughness * roughness;
  return sqrt(sqrt(a * a + spread));
}
