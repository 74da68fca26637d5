// The largest stable step of an integrator of the particles. Inside the room only.
#pragma once

#include <cmath>

namespace rotatebook::physics {

/// A displacement along a mode of the springs, or its velocity.
struct Displacement {
  double value = 0;
};

inline Displacement plus(Displacement one, double factor, Displacement other) {
  return {one.value + factor * other.value};
}

/// One mode of particles on springs, x'' = -s x - d x', as a state on which integrators work.
class Vibration {
 public:
  using Points = Displacement;

  /// `stiffness` s [1/s^2], `damping` d [1/s]
  Vibration(double stiffness, double damping, double position, double velocity)
      : stiffness_(stiffness), damping_(damping), position_{position}, velocity_{velocity} {}

  const Displacement& positions() const { return position_; }
  const Displacement& velocities() const { return velocity_; }
  Displacement& velocities() { return velocity_; }
  Displacement accelerations(Displacement velocity) const {
    return {-stiffness_ * position_.value - damping_ * velocity.value};
  }
  void moveTo(Displacement position) { position_ = position; }

 private:
  double stiffness_, damping_;
  Displacement position_, velocity_;
};

/// Returns the factor by which a step of `h` of the integrator lets a mode grow, in the long run.
template <typename Method>
double growthOf(double stiffness, double damping, double h) {
  Vibration first(stiffness, damping, 1, 0), second(stiffness, damping, 0, 1);
  Method::step(first, h);
  Method::step(second, h);
  const double a = first.positions().value, b = second.positions().value;
  const double c = first.velocities().value, d = second.velocities().value;
  const double half = (a + d) / 2, determinant = a * d - b * c;
  const double split = half * half - determinant;
  if (split < 0) return std::sqrt(determinant);
  return std::abs(half) + std::sqrt(split);
}

/// Returns the longest step for which the integrator lets the mode not grow, 0 if there is none.
/// [s]
template <typename Method>
double stableStepOf(double stiffness, double damping) {
  constexpr double kRounding = 1e-12;
  constexpr double kLongest = 4, kShortest = 1e-5;  // [1/sqrt(stiffness)]
  const double unit = 1 / std::sqrt(stiffness);
  double stable = 0, unstable = kLongest;
  for (int i = 0; i < 60; ++i) {
    const double middle = (stable + unstable) / 2;
    const bool isStable = growthOf<Method>(stiffness, damping, middle * unit) <= 1 + kRounding;
    (isStable ? stable : unstable) = middle;
  }
  return stable < kShortest ? 0 : stable * unit;
}

}  // namespace rotatebook::physics
