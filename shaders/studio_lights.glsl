#version 330 core
// The beginning of body.vert and cover.frag: the direction toward each light of the studio, so that
// scattered and mirrored light come from the same lights.
const vec3 kKeyDirection = vec3(0.4767, 0.5720, 0.6674);
const vec3 kFillDirection = vec3(-0.8452, 0.0528, 0.5317);
const vec3 kRimDirection = vec3(-0.3487, 0.6475, -0.6774);
