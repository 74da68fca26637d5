#version 330 core
// Cloth with gold stamping, or paper. Radiance is linear; the frame buffer encodes sRGB.
in vec2 texturePlace;
in vec3 arriving;
in vec3 mirrored;

uniform sampler2D albedo;
uniform float gloss;  // Strength of the mirrored light: 0 paper, 1 cover.

out vec4 colour;

const float kClothShine = 0.05;
const float kGoldShine = 0.9;

// How far a colour is that of gold: much less blue than green, much green beside the red.
float goldness(vec3 surface) {
  return clamp(4.0 * (surface.g - 0.35 * surface.r), 0.0, 1.0) *
         clamp(6.0 * (0.5 * surface.r - surface.b), 0.0, 1.0);
}

// Compresses highlights by luminance, so that the cover keeps its hue.
vec3 toneMap(vec3 radiance) {
  float luminance = dot(radiance, vec3(0.2126, 0.7152, 0.0722));
  return radiance * (1.0 + 0.06 * luminance) / (1.0 + 0.42 * luminance);
}

void main() {
  vec3 surface = texture(albedo, texturePlace).rgb;
  float gold = goldness(surface);
  vec3 shine = gloss * mix(vec3(kClothShine), kGoldShine * surface, gold);
  colour = vec4(toneMap(surface * arriving + shine * mirrored), 1.0);
}
