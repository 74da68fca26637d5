#version 330 core
// Linked with cover.frag and with paper.frag.

// Applies Khronos' PBR neutral tone curve: base colours stay, highlights are compressed and lose
// their hue.
vec3 toneMap(vec3 radiance) {
  const float kStart = 0.8 - 0.04, kDesaturation = 0.15;
  float least = min(radiance.r, min(radiance.g, radiance.b));
  radiance -= least < 0.08 ? least - 6.25 * least * least : 0.04;
  float peak = max(radiance.r, max(radiance.g, radiance.b));
  if (peak < kStart) return radiance;
  float room = 1.0 - kStart;
  float newPeak = 1.0 - room * room / (peak + room - kStart);
  float grey = 1.0 - 1.0 / (kDesaturation * (peak - newPeak) + 1.0);
  return mix(radiance * newPeak / peak, vec3(newPeak), grey);
}
