// Follows studio_scatter.glsl, before cover.frag and surface.frag: what the studio looks like in a
// surface that mirrors it. The light that matt surfaces scatter of it follows from its constants.
const float kDielectric = 0.04;  // Reflectance of what isn't a metal.
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

// Returns the normal of a surface at `position` (world) whose height changes from pixel to pixel
// (Mikkelsen, "Bump Mapping Unparametrized Surfaces on the GPU", 2010).
vec3 bumpedNormal(vec3 position, vec3 normal, float height) {
  vec3 acrossX = dFdx(position), acrossY = dFdy(position);
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

// Returns the studio's radiance, averaged over the GGX lobe about `mirrored`: a narrow lobe, and a
// long tail that sees what a matt surface scatters. Seen along the normal it is off by 0.08 in the
// mean, at any roughness. At grazing light the lobe is narrower.
vec3 studio(vec3 mirrored, vec3 normal, float roughness) {
  float a = roughness * roughness;
  float grazing = 0.5 + 0.5 * dot(mirrored, normal);
  float width = grazing * min(6.0 * a, 0.15 + 1.1 * roughness) + 0.01;
  float height = smoothstep(-0.5 - a, 0.7 + a, mirrored.y);
  vec3 light = mix(kBelow, kAbove, height) + kWall * smoothstep(0.1 - a, 1.0, mirrored.z);
  light += kKeyRadiance * filledShare(mirrored, kKeyDirection, kKeySize, width);
  light += kFillRadiance * filledShare(mirrored, kFillDirection, kFillSize, width);
  light += kRimRadiance * filledShare(mirrored, kRimDirection, kRimSize, width);
  vec3 tail = scatteredLight(normalize(mirrored + normal));
  return mix(light, tail, smoothstep(0.0, 1.0, roughness));
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
  float fresnel = kDielectric + (1.0 - kDielectric) * miss2 * miss2 * miss;
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
