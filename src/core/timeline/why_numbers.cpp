#include "timeline/why_numbers.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include <Eigen/Geometry>

#include "physics/free_motion.h"
#include "physics/motion_start.h"
#include "rigid/energy_ladder.h"
#include "rigid/poinsot.h"

namespace rotatebook::timeline {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

template <typename Values>
void addAll(std::vector<double>& numbers, const Values& values) {
  numbers.insert(numbers.end(), values.data(), values.data() + values.size());
}

}  // namespace

Vector3d momentsOf(const scene::Panel& panel) {
  return physics::modelInertia(panel).moments;
}

std::vector<double> ladderNumbers(const scene::Panel& panel, const physics::Sample& sample) {
  const auto inertia = physics::modelInertia(panel);
  const rigid::EnergyLadder ladder(inertia.moments);
  const Vector3d momentum = physics::momentumAlong(inertia, sample);
  const double energy = sample.total() / momentum.squaredNorm();
  const rigid::LadderPlace now = ladder.placeOf(momentum, energy);
  std::vector<double> numbers{now.height, ladder.reachAt(energy) / std::numbers::pi,
                              now.angle / std::numbers::pi, 100 * ladder.aboveMiddle(energy)};
  for (const int axis : ladder.axes()) {
    const bool isTurned = !inertia.bodyFromPrincipal.isIdentity(1e-9);
    const double spin = ladder.energyOf(axis);
    numbers.insert(numbers.end(), {static_cast<double>(axis), isTurned ? 1.0 : 0.0,
                                   ladder.heightOf(spin), ladder.reachAt(spin) / std::numbers::pi});
  }
  for (const rigid::LadderPlace& place : ladder.outline())
    numbers.insert(numbers.end(), {place.height, place.angle / std::numbers::pi});
  return numbers;
}

std::vector<double> poinsotNumbers(const scene::Panel& panel,
                                   const std::vector<physics::Sample>& samples, std::size_t index,
                                   const scene::MotionFrame& frame, std::size_t trail) {
  const auto inertia = physics::modelInertia(panel);
  Vector3d semiAxes = rigid::inertiaSemiAxes(inertia.moments);
  const double scale = panel.body.largestDimension() / 2 / semiAxes.maxCoeff();
  semiAxes *= scale;
  const auto contactOf = [&](const physics::Sample& sample) -> Vector3d {
    const auto poinsot = rigid::poinsotOf(inertia.moments, physics::momentumAlong(inertia, sample));
    return scale * (inertia.bodyFromPrincipal * poinsot.contact);
  };

  const physics::Sample& sample = samples[index];
  const Matrix3d frameFromWorld = frame.fromWorld(sample);
  const Matrix3d frameFromBody = frameFromWorld * sample.attitude.toRotationMatrix();
  const Vector3d centre = frameFromWorld * sample.cage.rowwise().mean();
  const double distance =
      scale * rigid::poinsotOf(inertia.moments, physics::momentumAlong(inertia, sample)).distance;
  if (!std::isfinite(distance)) return {};
  const auto radii = rigid::herpolhodeRadii(semiAxes, distance);
  const Vector3d normal = sample.angularMomentum.normalized(), across = normal.unitOrthogonal();

  std::vector<double> numbers{distance, radii.least, radii.greatest, semiAxes.maxCoeff()};
  addAll(numbers, centre);
  addAll(numbers, Matrix3d(frameFromBody * inertia.bodyFromPrincipal * semiAxes.asDiagonal()));
  addAll(numbers, Vector3d(frameFromWorld * across));
  addAll(numbers, Vector3d(frameFromWorld * normal.cross(across)));
  addAll(numbers, Vector3d(frameFromWorld * normal));
  const std::vector<std::size_t> starts = physics::freeStarts(samples, panel.nudges);
  const std::size_t since = *std::prev(std::upper_bound(starts.begin(), starts.end(), index));
  for (std::size_t i = std::max(since, index - std::min(index, trail)); i <= index; ++i) {
    const Vector3d contact = contactOf(samples[i]);
    if (!contact.allFinite()) continue;
    addAll(numbers, Vector3d(centre + frameFromBody * contact));
    addAll(numbers, Vector3d(centre + frameFromWorld * (samples[i].attitude * contact)));
  }
  return numbers;
}

}  // namespace rotatebook::timeline
