#version 330 core
// Matt paper. Radiance is linear; the frame buffer encodes sRGB.
in vec2 texturePlace;
in vec3 arriving;
flat in float onSurface;

uniform sampler2D albedo;

out vec4 colour;  // Alpha: the number of the surface, of 255.

vec3 toneMap(vec3 radiance);

void main() {
  vec3 radiance = texture(albedo, texturePlace).rgb * arriving;
  colour = vec4(toneMap(radiance), onSurface / 255.0);
}
