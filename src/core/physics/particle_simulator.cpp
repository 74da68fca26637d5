#include "physics/particle_simulator.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/QR>

namespace rotatebook::physics {
namespace {

constexpr int kParticles = 8;
// Least kinetic energy that normalisation leaves, as a fraction of the energy at t = 0.
constexpr double kEnergyFloor = 0.1;

Points fromEigen(const Corners& corners) {
  Points points;
  for (int axis = 0; axis < 3; ++axis) {
    for (int q = 0; q < 4; ++q) {
      points.at(axis).at(q) = Lanes{corners(axis, q), corners(axis, q + 4)};
    }
  }
  return points;
}

Corners toEigen(const Points& points) {
  Corners corners;
  for (int axis = 0; axis < 3; ++axis) {
    for (int q = 0; q < 4; ++q) {
      corners(axis, q) = points.at(axis).at(q)[0];
      corners(axis, q + 4) = points.at(axis).at(q)[1];
    }
  }
  return corners;
}

Corners turningVelocities(const Corners& corners, const Eigen::Vector3d& angularVelocity) {
  Corners velocities;
  for (int i = 0; i < corners.cols(); ++i) {
    velocities.col(i) = angularVelocity.cross(corners.col(i));
  }
  return velocities;
}

// About the point that `arms` start from.
Eigen::Matrix3d inertiaTensor(const Corners& arms, double mass) {
  const Eigen::Matrix3d products = arms * arms.transpose();
  return mass * (products.trace() * Eigen::Matrix3d::Identity() - products);
}

Eigen::Vector3d angularMomentumOf(const Corners& arms, const Corners& velocities, double mass) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < arms.cols(); ++i) sum += arms.col(i).cross(velocities.col(i));
  return mass * sum;
}

ParticleState startOf(const MotionSettings& settings) {
  const Corners corners = settings.body.corners();
  const double mass = settings.body.mass / kParticles, stiffness = settings.simulation.stiffness;
  const Points positions = fromEigen(corners);
  const SpringNetwork springs(positions, stiffness,
                              settings.simulation.damping * 2 * std::sqrt(stiffness * mass));
  return {positions, fromEigen(turningVelocities(corners, initialAngularVelocity(settings))), mass,
          springs};
}

}  // namespace

ParticleSimulator::ParticleSimulator(const MotionSettings& settings, ParticleStep step)
    : state_(startOf(settings)),
      step_(step),
      normalize_(settings.simulation.normalize),
      energy_(state_.kineticEnergy()) {}

void ParticleSimulator::advance(double h, int steps) {
  for (int step = 0; step < steps; ++step) {
    step_(state_, h);
    if (!normalize_) continue;
    restoreEnergy();
    state_.restoreCentre();
  }
}

void ParticleSimulator::restoreEnergy() {
  const double wanted = std::max(energy_ - state_.potentialEnergy(), kEnergyFloor * energy_);
  const double factor = std::sqrt(wanted / state_.kineticEnergy());
  for (Octet& components : state_.velocities()) {
    for (Lanes& lanes : components) lanes *= factor;
  }
}

BodyState ParticleSimulator::state() const {
  BodyState result;
  result.corners = toEigen(state_.positions());
  const Corners arms = result.corners.colwise() - result.corners.rowwise().mean().eval();
  const Eigen::Matrix3d inertia = inertiaTensor(arms, state_.mass());
  result.angularMomentum = angularMomentumOf(arms, toEigen(state_.velocities()), state_.mass());
  // The smallest solution, which stays finite where the particles lie on one line and their inertia
  // is singular.
  result.angularVelocity = inertia.completeOrthogonalDecomposition().solve(result.angularMomentum);
  result.kinetic = state_.kineticEnergy();
  result.potential = state_.potentialEnergy();
  result.rotational = result.angularVelocity.dot(result.angularMomentum) / 2;
  return result;
}

}  // namespace rotatebook::physics
