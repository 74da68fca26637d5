// Simbody's body, apart from this program's headers: Simbody's own compare with operators that
// C++20 calls ambiguous, while ours need C++20.
#pragma once

#include <array>
#include <memory>

namespace rotatebook::bench {

/// One body on a free mobilizer, integrated with steps that the accuracy, 1e-9, chooses.
class SimbodyBody {
 public:
  /// Takes the mass [kg], the principal moments [kg m^2] and the spin at t = 0 [rad/s].
  SimbodyBody(double mass, const std::array<double, 3>& moments, const std::array<double, 3>& spin);
  ~SimbodyBody();

  /// Goes on to a time. [s]
  void advanceTo(double time);
  /// Returns the matrix, world from body, row by row.
  std::array<double, 9> attitude() const;
  /// Returns the angular velocity in world axes. [rad/s]
  std::array<double, 3> angularVelocity() const;
  int stepsTaken() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Returns Simbody's version, major and minor.
std::array<int, 2> simbodyVersion();

}  // namespace rotatebook::bench
