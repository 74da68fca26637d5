#version 330 core
// Linked with cover.frag, surface.frag and paper.frag: makes a pixel of the radiance that they
// computed.

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
  return mix(radiance * (newPeak / peak), vec3(newPeak), grey);
}

// Returns the sRGB value of linear light, both 0 to 1 (IEC 61966-2-1), within 0.0012 of an 8-bit
// level. Its power of 1/2.4 is fitted by square roots, which all processors round alike; what a
// frame buffer or pow() encodes differs from one to another.
vec3 encodedSrgb(vec3 light) {
  vec3 root = sqrt(light), quarter = sqrt(root), threeEighths = sqrt(root * quarter);
  vec3 power = 0.280456565 * root + 0.874423457 * threeEighths - 0.0982486709 * quarter -
               0.00405176873 * light - 0.0525840109;
  return mix(power, 12.92 * light, lessThanEqual(light, vec3(0.0031308)));
}

// Returns the colour of a pixel that has this radiance. Encoded as sRGB.
vec3 pixelColour(vec3 radiance) {
  return encodedSrgb(clamp(toneMap(radiance), 0.0, 1.0));
}
