#include "physics/particle_simulator.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/QR>

#include "physics/motion_start.h"
#include "rigid/rotation.h"

namespace rotatebook::physics {
namespace {

constexpr int kParticles = 8;
// Minimum kinetic energy after normalisation, as a fraction of the energy at t = 0.
constexpr double kEnergyFloor = 0.1;

Points fromEigen(const Cage& cage) {
  Points points;
  for (int axis = 0; axis < 3; ++axis) {
    for (int q = 0; q < 4; ++q) {
      points.at(axis).at(q) = DoublePair{cage(axis, q), cage(axis, q + 4)};
    }
  }
  return points;
}

Cage toEigen(const Points& points) {
  Cage cage;
  for (int axis = 0; axis < 3; ++axis) {
    for (int q = 0; q < 4; ++q) {
      cage(axis, q) = points.at(axis).at(q)[0];
      cage(axis, q + 4) = points.at(axis).at(q)[1];
    }
  }
  return cage;
}

Cage turningVelocities(const Cage& cage, const Eigen::Vector3d& angularVelocity) {
  Cage velocities;
  for (int i = 0; i < cage.cols(); ++i) {
    velocities.col(i) = angularVelocity.cross(cage.col(i));
  }
  return velocities;
}

// Returns the inertia tensor about the point from which `arms` start.
Eigen::Matrix3d inertiaTensor(const Cage& arms, double mass) {
  const Eigen::Matrix3d products = arms * arms.transpose();
  return mass * (products.trace() * Eigen::Matrix3d::Identity() - products);
}

Eigen::Vector3d angularMomentumOf(const Cage& arms, const Cage& velocities, double mass) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < arms.cols(); ++i) sum += arms.col(i).cross(velocities.col(i));
  return mass * sum;
}

ParticleState startOf(const MotionSettings& settings) {
  const Cage corners = settings.body.corners();
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
      energyNormalization_(settings.simulation.energyEvery()),
      driftRemoval_(settings.simulation.driftEvery()),
      energy_(state_.kineticEnergy()),
      fit_(settings.body) {}

void ParticleSimulator::advance(double interval, int steps) {
  const double h = interval / steps;
  for (int step = 0; step < steps; ++step) {
    step_(state_, h);
    if (energyNormalization_.isDue()) restoreEnergy();
    if (driftRemoval_.isDue()) state_.restoreCentre();
  }
}

void ParticleSimulator::restoreEnergy() {
  const double wanted = std::max(energy_ - state_.potentialEnergy(), kEnergyFloor * energy_);
  const double factor = std::sqrt(wanted / state_.kineticEnergy());
  for (EightDoubles& components : state_.velocities()) {
    for (DoublePair& lanes : components) lanes *= factor;
  }
}

void ParticleSimulator::nudge(const Nudge& nudge) {
  const Cage cage = toEigen(state_.positions());
  const Cage arms = cage.colwise() - cage.rowwise().mean().eval();
  Eigen::Vector3d change = nudge.value;
  if (nudge.axes == Nudge::Axes::Body) {
    change = rigid::polarDecomposition(fit_.worldFromBody(cage)).rotation * change;
  }
  if (nudge.kind == SpinKind::AngularMomentum) {
    change = inertiaTensor(arms, state_.mass()).completeOrthogonalDecomposition().solve(change);
  }
  const double before = state_.kineticEnergy();
  state_.velocities() = fromEigen(toEigen(state_.velocities()) + turningVelocities(arms, change));
  energy_ += state_.kineticEnergy() - before;
}

BodyState ParticleSimulator::state() const {
  BodyState result;
  const Cage cage = toEigen(state_.positions());
  result.worldFromBody = fit_.worldFromBody(cage);
  result.cage = cage;
  const Cage arms = cage.colwise() - cage.rowwise().mean().eval();
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

}  // namespace rotatebook::physics
