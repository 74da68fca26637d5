// Eight points, each pair of them joined by a spring and a damper.
#pragma once

#include <array>
#include <cstddef>

namespace rotatebook::physics {

/// The same component of two particles: processors compute both at once, each as if alone.
using DoublePair = double __attribute__((vector_size(16)));
/// A component of eight particles; element q holds those of q and q + 4.
using EightDoubles = std::array<DoublePair, 4>;
/// Their x, y and z.
using Points = std::array<EightDoubles, 3>;

/// Sum of eight numbers, in a fixed order.
double sumOf(const EightDoubles& numbers);
/// Sum of the squares of all components, in a fixed order.
double squaredNormOf(const Points& points);
/// points + factor * others.
Points plus(const Points& points, double factor, const Points& others);

/// 28 springs between eight points, and what depends on the points' positions alone: it is computed
/// once for each position, and serves the energy and the next forces.
class SpringNetwork {
 public:
  /// Springs at rest at `positions` [m], of `stiffness` [N/m], with dampers of `damping` [kg/s].
  SpringNetwork(const Points& positions, double stiffness, double damping);

  /// Takes the points' new positions. [m]
  void moveTo(const Points& positions);
  /// Force on each point at these velocities [m/s]. [N]
  Points forces(const Points& velocities) const;
  /// Energy in the springs. [J]
  double energy() const;

 private:
  // Two springs. Twelve of these join different pairs of points; the last four join q and q + 4, in
  // one lane as seen from q and in the other as seen from q + 4.
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
