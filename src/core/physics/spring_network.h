// Eight points, each pair of which is joined by a spring and a damper. Inside the room only.
#pragma once

#include <array>
#include <cstddef>

namespace rotatebook::physics {

/// One component of two particles, which processors compute at once (SIMD), each as if alone.
using DoublePair = double __attribute__((vector_size(16)));
/// One component of eight particles; element q holds those of q and q + 4.
using EightDoubles = std::array<DoublePair, 4>;
/// The x, y and z of eight particles.
using Points = std::array<EightDoubles, 3>;

/// Returns the sum of eight numbers, added in a fixed order.
double sumOf(const EightDoubles& numbers);
/// Returns the sum of the squares of all components, added in a fixed order.
double squaredNormOf(const Points& points);
/// Returns points + factor * others.
Points plus(const Points& points, double factor, const Points& others);
/// Multiplies all components by `factor`.
void scale(Points& points, double factor);
/// Moves the points so that their mean is 0.
void subtractMean(Points& points);

/// 28 springs between eight points, and what depends on the points' positions alone: it is computed
/// once per position, for both the energy and the next forces.
class SpringNetwork {
 public:
  using Points = physics::Points;

  /// Springs of `stiffness` [N/m], at rest at `positions` [m], with dampers of `damping` [kg/s].
  SpringNetwork(const Points& positions, double stiffness, double damping);

  /// Moves the points to `positions`. [m]
  void moveTo(const Points& positions);
  /// Returns the force on each point at these velocities [m/s]. [N]
  Points forces(const Points& velocities) const;
  /// Returns the energy in the springs. [J]
  double energy() const;

 private:
  // Two springs, one per lane. Twelve such pairs join different points; the last four join q and q
  // + 4, as seen from q in one lane and from q + 4 in the other.
  struct Springs {
    std::array<DoublePair, 3> directions{};  // unit vectors from each point to its partner
    DoublePair lengths{};
    DoublePair restLengths{};
  };
  static constexpr std::size_t kCount = 16;

  std::array<Springs, kCount> springs_{};
  double stiffness_;
  double damping_;
};

}  // namespace rotatebook::physics
