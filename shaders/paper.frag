#version 330 core
// Matt paper. Radiance is linear.
in vec2 texCoord;
in vec3 diffuseLight;
flat in float surfaceId;

uniform sampler2D albedo;

out vec4 colour;  // Encoded as sRGB; alpha: surfaceId / 255.

vec3 pixelColour(vec3 radiance);

const float kMirrored = 0.03;  // Share that the roughest surface mirrors, from all sides.

void main() {
  vec3 radiance = (texture(albedo, texCoord).rgb + kMirrored) * diffuseLight;
  colour = vec4(pixelColour(radiance), surfaceId / 255.0);
}
