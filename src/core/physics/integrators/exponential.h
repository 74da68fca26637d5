// Rotations from an axis and an angle. Sine and cosine are summed here from additions and
// multiplications alone, because those of C libraries differ in the last digit from machine to
// machine, and a motion must not. Inside the room only.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace rotatebook::physics {

/// cos(x) and sin(x)/x, from x^2.
struct CosineSinc {
  double cosine;
  double sinc;
};

/// Sums the Taylor series of both, to 1e-17 for 0 <= `xx` = x^2 <= 1/4.
inline CosineSinc cosineSinc(double xx) {
  double cosine = 1, sinc = 1;
  for (int n = 16; n > 0; n -= 2) {
    cosine = 1 - xx * (1.0 / ((n - 1) * n)) * cosine;
    sinc = 1 - xx * (1.0 / (n * (n + 1))) * sinc;
  }
  return {cosine, sinc};
}

/// Returns the unit quaternion that rotates by `rotation`, axis times angle [rad]. For angles over
/// a radian it squares the quaternion of a fraction of the rotation: NaN gives NaN, and the error
/// grows with the angle as that of sine does.
inline Eigen::Quaterniond rotationBy(const Eigen::Vector3d& rotation) {
  Eigen::Vector3d half = rotation / 2;
  int doublings = 0;
  while (half.squaredNorm() > 0.25 && doublings < 64) {
    half /= 2;
    ++doublings;
  }
  const auto [cosine, sinc] = cosineSinc(half.squaredNorm());
  Eigen::Quaterniond result(cosine, sinc * half.x(), sinc * half.y(), sinc * half.z());
  if (doublings == 0) return result;
  // Normalise, because squaring doubles the error of the norm.
  for (; doublings > 0; --doublings) result = (result * result).normalized();
  return result;
}

}  // namespace rotatebook::physics
