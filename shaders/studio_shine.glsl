// Follows studio_scatter.glsl, before cover.frag and surface.frag: what the studio looks like in a
// surface that mirrors it. The light that matt surfaces scatter of it follows from its constants.
const float kMaxSpread = 0.5;  // Greatest increase of the squared GGX width.
// Of its roughness: glass and fibres mirror flat light most, as if they were smoother.
const float kDielectricLobe = 0.88;

const vec3 kBelow = vec3(0.34, 0.30, 0.27);
const vec3 kAbove = vec3(0.64, 0.66, 0.70);
const vec3 kWall = vec3(0.90, 0.86, 0.80);  // The photographer's, which is lit.

// Two softboxes in front and a strip light behind: direction, radiance, and half width and half
// height as tangents of angles.
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

// Returns the share of a lobe about `middle` that a softbox fills: it ends 1 / `sharpness` from its
// middle, and three quarters of it are within half of that.
float filledShare(vec3 middle, vec3 direction, vec2 halfSize, float sharpness) {
  vec3 side = normalize(vec3(direction.z, 0.0, -direction.x));
  vec3 up = cross(direction, side);
  float ahead = dot(middle, direction);
  vec2 position = vec2(dot(middle, side), dot(middle, up)) * (1.0 / max(ahead, 0.05));
  vec4 beyond = clamp(sharpness * vec4(halfSize + position, halfSize - position), -1.0, 1.0);
  vec4 part = beyond * (2.0 - abs(beyond));
  vec2 filled = part.xy + part.zw;
  return ahead > 0.0 ? 0.25 * filled.x * filled.y : 0.0;
}

// Returns the studio's radiance, averaged over the GGX lobe about `mirrored`: what is mirrored, and
// of rough surfaces more and more of what a matt one scatters. At grazing light the lobe is narrower
// and leans toward the normal.
vec3 studio(vec3 mirrored, vec3 normal, float roughness) {
  float cosine = dot(mirrored, normal), grazing = 0.5 + 0.5 * cosine;
  vec3 middle = normalize(mirrored + 0.8 * roughness * roughness * (1.0 - cosine) * normal);
  float sharpness = 1.0 / (1.95 * grazing * roughness * min(3.2 * roughness, 1.0) + 0.005);
  vec3 light = mix(kBelow, kAbove, smoothstep(-0.5, 0.7, middle.y));
  light += kWall * smoothstep(0.1, 1.0, middle.z);
  light += kKeyRadiance * filledShare(middle, kKeyDirection, kKeySize, sharpness);
  light += kFillRadiance * filledShare(middle, kFillDirection, kFillSize, sharpness);
  light += kRimRadiance * filledShare(middle, kRimDirection, kRimSize, sharpness);
  vec3 scattered = scatteredLight(normalize(mirrored + 1.5 * normal));
  return mix(light, scattered, grazing * smoothstep(0.09, 1.0, roughness));
}

// Returns the share of the studio's radiance that what isn't a metal mirrors: Fresnel's formula for
// glass and fibres, averaged over the GGX lobe, within 7 % in the mean.
float dielectricShare(float roughness, float nv) {
  float r2 = roughness * roughness, miss = 1.0 - nv, miss2 = miss * miss;
  float rise = miss2 * (0.189 + 0.0634 * miss2 * miss) / (0.192 + nv + 4.41 * r2);
  return 0.04 - 0.0275 * r2 * roughness + rise;
}

// Returns the share that a surface mirrors of which `metal` is metal, `base` the sum of its colours:
// Schlick's approximation, likewise.
vec3 metalShare(float metal, vec3 base, float roughness, float nv) {
  float r2 = roughness * roughness, miss = 1.0 - nv, miss2 = miss * miss;
  float full = 1.0 - r2 * (0.68 - 0.25 * miss), edge = 0.87 / (1.0 + 11.3 * r2) * miss2 * miss2;
  return metal * edge + (full - edge) * base;
}

// Returns the roughness whose lobe is as wide as that of all the pixel's normals together
// (Tokuyoshi and Kaplanyan, "Improved Geometric Specular Antialiasing", 2019).
float widenedRoughness(float roughness, vec3 normal) {
  vec3 x = dFdx(normal), y = dFdy(normal);
  float spread = min(0.12 * (dot(x, x) + dot(y, y)), kMaxSpread);
  float a = roughness * roughness;
  return sqrt(sqrt(a * a + spread));
}
