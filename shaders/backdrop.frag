#version 330 core
// The background as it was drawn once, pixel by pixel.
uniform sampler2D backdrop;

out vec4 colour;

void main() { colour = texelFetch(backdrop, ivec2(gl_FragCoord.xy), 0); }
