#version 330 core
// The beginning of body.vert, and of cover.frag and surface.frag before studio_shine.glsl.
//
// What a matt surface scatters of studio_shine.glsl's light, irradiance / pi: the polynomial of
// second order that is nearest to it (Ramamoorthi and Hanrahan, "An Efficient Representation for
// Irradiance Environment Maps", 2001), and one of fourth order about the brightest light; off by
// 0.006 in the mean. bench/beside/studio.py fits it.
const vec3 kKeyDirection = vec3(0.4767, 0.5720, 0.6674);
const vec3 kEven = vec3(0.9660, 0.9490, 0.9479);
const vec3 kX = vec3(0.0430, 0.0096, -0.0436);
const vec3 kY = vec3(0.4080, 0.4311, 0.4568);
const vec3 kZ = vec3(0.4830, 0.4544, 0.4179);
const vec3 kXy = vec3(0.1020, 0.0840, 0.0587);
const vec3 kYz = vec3(0.1305, 0.1052, 0.0708);
const vec3 kZx = vec3(0.1336, 0.1088, 0.0677);
const vec3 kXxYy = vec3(-0.0020, 0.0019, 0.0097);
const vec3 kZz = vec3(0.0597, 0.0560, 0.0502);
const vec3 kFourth = vec3(-0.0450, -0.0436, -0.0420);

vec3 scatteredLight(vec3 normal) {
  float x = normal.x, y = normal.y, z = normal.z;
  float key = dot(normal, kKeyDirection), key2 = key * key;
  return kEven + kX * x + kY * y + kZ * z + kXy * (x * y) + kYz * (y * z) + kZx * (z * x) +
         kXxYy * (x * x - y * y) + kZz * (3.0 * z * z - 1.0) +
         kFourth * ((4.375 * key2 - 3.75) * key2 + 0.375);
}
