#include "rigid/energy_ladder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/elementary.h"
#include "rigid/poinsot.h"
#include "rigid/regime.h"

namespace rotatebook::rigid {
namespace {

constexpr int kOutlineRows = 60;  // from each end to the middle

}  // namespace

EnergyLadder::EnergyLadder(const Eigen::Vector3d& moments)
    : axes_(axesByInertia(moments)), energies_(axisEnergies(moments, 1)) {}

double EnergyLadder::heightOf(double energy) const {
  const double low = energyOf(axes_[2]), high = energyOf(axes_[0]);
  return high > low ? std::clamp((energy - low) / (high - low), 0.0, 1.0) : 0.5;
}

double EnergyLadder::reachAt(double energy) const {
  return reachOfMomentum(energies_, energy);
}

LadderPlace EnergyLadder::placeOf(const Eigen::Vector3d& momentum, double energy) const {
  const int circled = axes_[energy > energyOf(axes_[1]) ? 0 : 2];
  const double angle = arcTangent(momentum[axes_[1]], std::abs(momentum[circled]));
  const double reach = reachAt(energy);
  return {heightOf(energy), std::clamp(angle, -reach, reach)};
}

std::vector<LadderPlace> EnergyLadder::outline() const {
  std::vector<LadderPlace> places;
  const double middle = energyOf(axes_[1]);
  for (const bool upper : {true, false}) {
    const double end = energyOf(axes_[upper ? 0 : 2]);
    for (int i = 0; i <= kOutlineRows; ++i) {
      // Denser toward both, where the width changes most.
      const int row = upper ? i : kOutlineRows - i;
      const double energy =
          end + (middle - end) * (1 - cosine(std::numbers::pi * row / kOutlineRows)) / 2;
      places.push_back({heightOf(energy), reachAt(energy)});
    }
  }
  return places;
}

}  // namespace rotatebook::rigid
