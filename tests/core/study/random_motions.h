// Random motions, the same ones in every build.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "physics/motion_settings.h"

namespace rotatebook::study::lanes::testing {

/// Numbers of Marsaglia's xorshift.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15U + 1) {}

  /// Returns a number in [0, 1).
  double unit() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return static_cast<double>(state_ >> 11) * 0x1p-53;
  }
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// Returns one of two positive numbers or a number between, spread over the powers of ten.
  double scaleBetween(double low, double high) {
    return low * std::exp(unit() * std::log(high / low));
  }
  int below(int count) { return static_cast<int>(unit() * count); }

 private:
  std::uint64_t state_;
};

/// A book of any size with a spin near one of its axes, in steps of `h` [s].
inline physics::MotionSettings randomMotion(Random& random, physics::Integrator integrator,
                                            double h, double tilt) {
  physics::MotionSettings settings;
  for (int i = 0; i < 3; ++i) settings.body.size[i] = random.between(0.03, 0.3);
  settings.body.mass = random.between(0.2, 3);
  settings.simulation.integrator = integrator;
  settings.simulation.substeps = 1;
  settings.simulation.timePerFrame = h;
  const int axis = random.below(3);
  settings.initial.value = Eigen::Vector3d::Zero();
  settings.initial.value[axis] = random.between(1, 12) * (random.unit() < 0.5 ? -1 : 1);
  settings.initial.value[(axis + 1 + random.below(2)) % 3] =
      tilt * std::fabs(settings.initial.value[axis]);
  return settings;
}

/// As many motions as they come up in maps: steps of 16 us to 16 ms, tilts of 1e-8 to 0.3.
inline std::vector<physics::MotionSettings> ordinaryMotions(std::size_t count,
                                                            physics::Integrator integrator,
                                                            std::uint64_t seed) {
  Random random(seed);
  std::vector<physics::MotionSettings> motions;
  while (motions.size() < count) {
    const double h = random.scaleBetween(16e-6, 16e-3);
    motions.push_back(randomMotion(random, integrator, h, random.scaleBetween(1e-8, 0.3)));
  }
  return motions;
}

/// Motions that blow up, have no solution, stand still along an axis or are nearly so: steps of 1
/// ms to 1 s, tilts of 0, -0 and 1e-300 up, every third not normalised.
inline std::vector<physics::MotionSettings> hardMotions(std::size_t count,
                                                        physics::Integrator integrator,
                                                        std::uint64_t seed) {
  Random random(seed);
  std::vector<physics::MotionSettings> motions;
  while (motions.size() < count) {
    const double h = random.scaleBetween(1e-3, 1);
    const double kind = random.unit();
    const double tilt = kind < 0.1 ? 0.0 : kind < 0.2 ? -0.0 : random.scaleBetween(1e-300, 1);
    motions.push_back(randomMotion(random, integrator, h, tilt));
    motions.back().simulation.normalizeEvery = static_cast<int>(motions.size() % 3);
  }
  return motions;
}

}  // namespace rotatebook::study::lanes::testing
