#version 330 core
// Cloth or paper under a warm key, a cool fill and a rim light. Radiance is linear; the frame buffer encodes sRGB.
in vec3 worldPlace;
in vec3 worldNormal;
in vec2 texturePlace;
in float skyShare;

uniform sampler2D albedo;
uniform vec3 eye;      // World. [m]
uniform float gloss;   // Strength of the sheen: 0 paper, 1 stamped cloth.

out vec4 colour;

// Directions toward the lights, as seen by a camera on +z: right and above, left, above behind.
const vec3 kKeyDirection = vec3(0.4767, 0.5720, 0.6674);
const vec3 kFillDirection = vec3(-0.8452, 0.0528, 0.5317);
const vec3 kRimDirection = vec3(-0.3487, 0.6475, -0.6774);
const vec3 kKeyColour = vec3(2.30, 2.16, 1.96);
const vec3 kFillColour = vec3(0.42, 0.50, 0.62);
const vec3 kRimColour = vec3(0.90, 1.00, 1.15);
const vec3 kSky = vec3(0.30, 0.32, 0.36);
const vec3 kGround = vec3(0.13, 0.12, 0.11);

float sheen(vec3 normal, vec3 toEye, vec3 toLight, float sharpness) {
  float cosine = max(dot(normal, normalize(toEye + toLight)), 0.0);
  return pow(cosine, sharpness) * max(dot(normal, toLight), 0.0);
}

// Compresses highlights by luminance, so that the cover keeps its hue.
vec3 toneMap(vec3 radiance) {
  float luminance = dot(radiance, vec3(0.2126, 0.7152, 0.0722));
  const float kWhite = 3.2;
  return radiance * (1.0 + luminance / (kWhite * kWhite)) / (1.0 + 0.55 * luminance);
}

void main() {
  vec3 toEye = normalize(eye - worldPlace);
  vec3 normal = normalize(worldNormal);
  if (dot(normal, toEye) < 0.0) normal = -normal;  // An inside-out face is lit on the side that is seen.

  vec3 surface = texture(albedo, texturePlace).rgb;
  vec3 light = mix(kGround, kSky, 0.5 + 0.5 * normal.y) * skyShare;
  light += kKeyColour * max(dot(normal, kKeyDirection), 0.0) * skyShare;
  light += kFillColour * max(dot(normal, kFillDirection), 0.0) * skyShare;
  light += kRimColour * max(dot(normal, kRimDirection), 0.0) * skyShare;

  vec3 reflected = kKeyColour * sheen(normal, toEye, kKeyDirection, 28.0) +
                   kFillColour * sheen(normal, toEye, kFillDirection, 18.0);
  float grazing = pow(1.0 - max(dot(normal, toEye), 0.0), 4.0);
  reflected += kRimColour * grazing * 0.35;
  // Gold stamping is bright against the cloth: let it shine more than the weave does.
  float shine = gloss * mix(0.05, 0.55, smoothstep(0.12, 0.45, surface.g));

  colour = vec4(toneMap(surface * light + shine * reflected * mix(vec3(1.0), surface, 0.6)), 1.0);
}
