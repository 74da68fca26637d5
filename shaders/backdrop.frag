#version 330 core
// The background as it was drawn once, pixel by pixel.
uniform sampler2D backdrop;
uniform int supersample;  // Pixels drawn, across and down, for one of the picture.

out vec4 colour;

void main() { colour = texelFetch(backdrop, ivec2(gl_FragCoord.xy) / supersample, 0); }
