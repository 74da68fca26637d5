#include "physics/particle_simulator.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/QR>

#include "physics/motion_start.h"
#include "physics/particle_places.h"
#include "rigid/rotation.h"

namespace rotatebook::physics {
namespace {

// Minimum kinetic energy after normalisation, as a fraction of the energy at t = 0.
constexpr double kEnergyFloor = 0.1;

/// The vectors of all particles as the columns of a matrix, and back.
body::Cage toEigen(const Points& points) {
  body::Cage cage;
  for (int axis = 0; axis < 3; ++axis) {
    for (int q = 0; q < 4; ++q) {
      cage(axis, q) = points.at(axis).at(q)[0];
      cage(axis, q + 4) = points.at(axis).at(q)[1];
    }
  }
  return cage;
}

void copyTo(Points& points, const Eigen::Matrix3Xd& columns) {
  for (int axis = 0; axis < 3; ++axis) {
    for (int q = 0; q < 4; ++q) {
      points.at(axis).at(q) = DoublePair{columns(axis, q), columns(axis, q + 4)};
    }
  }
}

Eigen::Matrix3Xd toEigen(const PointList& list) {
  Eigen::Matrix3Xd columns(3, static_cast<Eigen::Index>(list.points.size()));
  for (Eigen::Index i = 0; i < columns.cols(); ++i)
    columns.col(i) = list.points[static_cast<std::size_t>(i)];
  return columns;
}

void copyTo(PointList& list, const Eigen::Matrix3Xd& columns) {
  list.points.clear();
  for (const auto& column : columns.colwise()) list.points.emplace_back(column);
}

template <typename Points>
Points pointsFrom(const Eigen::Matrix3Xd& columns) {
  Points points;
  copyTo(points, columns);
  return points;
}

template <typename Columns>
Columns turningVelocities(const Columns& columns, const Eigen::Vector3d& angularVelocity) {
  Columns velocities = columns;
  for (Eigen::Index i = 0; i < columns.cols(); ++i) {
    velocities.col(i) = angularVelocity.cross(columns.col(i));
  }
  return velocities;
}

template <typename Columns>
Columns armsOf(const Columns& positions) {
  return positions.colwise() - positions.rowwise().mean().eval();
}

// Returns the inertia tensor about the point from which `arms` start.
template <typename Columns>
Eigen::Matrix3d inertiaTensor(const Columns& arms, double mass) {
  // In the order of the particles, as a product by blocks wouldn't be
  const Eigen::Matrix3d products = arms.lazyProduct(arms.transpose());
  return mass * (products.trace() * Eigen::Matrix3d::Identity() - products);
}

template <typename Columns>
Eigen::Vector3d angularMomentumOf(const Columns& arms, const Columns& velocities, double mass) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < arms.cols(); ++i) sum += arms.col(i).cross(velocities.col(i));
  return mass * sum;
}

SpringNetwork springsAt(const Points& positions, const MassSpringSystem& /*all pairs*/,
                        double stiffness, double damping) {
  return {positions, stiffness, damping};
}

ManySprings springsAt(const PointList& positions, const MassSpringSystem& particles,
                      double stiffness, double damping) {
  return {positions, particles.springs, stiffness, damping};
}

template <typename Springs>
BasicParticleState<Springs> startOf(const MotionSettings& settings) {
  using Points = typename Springs::Points;
  const MassSpringSystem particles = particlesOf(settings);
  const Eigen::Matrix3Xd places = toEigen(PointList{particles.places});
  const double mass = settings.body.mass / static_cast<double>(places.cols());
  const double stiffness = settings.simulation.stiffness;
  const auto positions = pointsFrom<Points>(places);
  const Springs springs = springsAt(positions, particles, stiffness,
                                    settings.simulation.damping * 2 * std::sqrt(stiffness * mass));
  return {positions,
          pointsFrom<Points>(turningVelocities(places, initialAngularVelocity(settings))), mass,
          springs};
}

std::shared_ptr<const ParticleFit> placedFitOf(const MotionSettings& settings) {
  if (settings.simulation.particles.arrangement == Arrangement::Corners) return nullptr;
  return std::make_shared<ParticleFit>(settings.body, particlesOf(settings));
}

}  // namespace

template <typename Springs>
BasicParticleSimulator<Springs>::BasicParticleSimulator(const MotionSettings& settings,
                                                        BasicParticleStep<Springs> step)
    : state_(startOf<Springs>(settings)),
      step_(step),
      energyNormalization_(settings.simulation.energyEvery()),
      driftRemoval_(settings.simulation.driftEvery()),
      energy_(state_.kineticEnergy()),
      fit_(settings.body),
      placedFit_(placedFitOf(settings)) {}

template <typename Springs>
void BasicParticleSimulator<Springs>::advance(double interval, int steps) {
  const double h = interval / steps;
  for (int step = 0; step < steps; ++step) {
    step_(state_, h);
    if (energyNormalization_.isDue()) restoreEnergy();
    if (driftRemoval_.isDue()) state_.restoreCentre();
  }
}

template <typename Springs>
void BasicParticleSimulator<Springs>::restoreEnergy() {
  const double wanted = std::max(energy_ - state_.potentialEnergy(), kEnergyFloor * energy_);
  scale(state_.velocities(), std::sqrt(wanted / state_.kineticEnergy()));
}

template <typename Springs>
template <typename Positions>
Eigen::Matrix3d BasicParticleSimulator<Springs>::worldFromBody(const Positions& positions) const {
  return placedFit_ ? placedFit_->worldFromBody(positions) : fit_.worldFromBody(positions);
}

template <typename Springs>
void BasicParticleSimulator<Springs>::nudge(const Nudge& nudge) {
  const auto positions = toEigen(state_.positions());
  const auto arms = armsOf(positions);
  Eigen::Vector3d change = nudge.value;
  if (nudge.axes == Nudge::Axes::Body) {
    change = rigid::polarDecomposition(worldFromBody(positions)).rotation * change;
  }
  if (nudge.kind == SpinKind::AngularMomentum) {
    change = inertiaTensor(arms, state_.mass()).completeOrthogonalDecomposition().solve(change);
  }
  const double before = state_.kineticEnergy();
  copyTo(state_.velocities(), toEigen(state_.velocities()) + turningVelocities(arms, change));
  energy_ += state_.kineticEnergy() - before;
}

template <typename Springs>
BodyState BasicParticleSimulator<Springs>::state() const {
  BodyState result;
  const auto positions = toEigen(state_.positions());
  result.worldFromBody = worldFromBody(positions);
  result.cage = placedFit_ ? placedFit_->cageOf(positions) : body::Cage(positions);
  const auto arms = armsOf(positions);
  const Eigen::Matrix3d inertia = inertiaTensor(arms, state_.mass());
  result.angularMomentum = angularMomentumOf(arms, toEigen(state_.velocities()), state_.mass());
  // Take the minimum-norm solution, which stays finite where the particles are collinear and their
  // inertia is singular.
  result.angularVelocity = inertia.completeOrthogonalDecomposition().solve(result.angularMomentum);
  result.kinetic = state_.kineticEnergy();
  result.potential = state_.potentialEnergy();
  result.rotational = result.angularVelocity.dot(result.angularMomentum) / 2;
  return result;
}

template class BasicParticleSimulator<SpringNetwork>;
template class BasicParticleSimulator<ManySprings>;

}  // namespace rotatebook::physics
