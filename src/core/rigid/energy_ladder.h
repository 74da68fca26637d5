// The energies that one size of the angular momentum L allows a body, as a ladder.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

namespace rotatebook::rigid {

/// A place on the ladder.
struct LadderPlace {
  double height;  ///< 0 for the least energy, of a spin about the largest moment's axis, to 1.
  double angle;   ///< From the axis that L circles toward the middle one. [rad]
};

/// The ladder, whose width at each energy says how far L goes to both sides of the axis that it
/// circles in the body: nowhere at the ends, to the middle axis at that one's energy. Energies are
/// divided by L^2. [1 / (kg m^2)]
class EnergyLadder {
 public:
  explicit EnergyLadder(const Eigen::Vector3d& moments);

  /// The principal axes, from the smallest moment, at the top, to the largest.
  const std::array<int, 3>& axes() const { return axes_; }
  /// Returns the energy of a spin about a principal axis, 0 to 2.
  double energyOf(int axis) const { return energies_[axis]; }

  /// Returns 0 to 1, and 1/2 if all moments are equal.
  double heightOf(double energy) const;
  /// Returns half the width, reachOfMomentum(). [rad]
  double reachAt(double energy) const;
  /// Returns by which share of the middle axis' energy `energy` is above it.
  double aboveMiddle(double energy) const { return energy / energyOf(axes_[1]) - 1; }
  /// Returns where the angular momentum is, which is along the principal axes.
  LadderPlace placeOf(const Eigen::Vector3d& momentum, double energy) const;
  /// Returns the outline's side of positive angles, from the top downward.
  std::vector<LadderPlace> outline() const;

 private:
  std::array<int, 3> axes_;
  Eigen::Vector3d energies_;
};

}  // namespace rotatebook::rigid
