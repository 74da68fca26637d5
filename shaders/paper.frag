#version 330 core
// Matt paper. Radiance is linear; the frame buffer encodes sRGB.
in vec2 texCoord;
in vec3 diffuseLight;
flat in float surfaceId;

uniform sampler2D albedo;

out vec4 colour;  // Alpha: surfaceId / 255.

vec3 toneMap(vec3 radiance);

void main() {
  vec3 radiance = texture(albedo, texCoord).rgb * diffuseLight;
  colour = vec4(toneMap(radiance), surfaceId / 255.0);
}
