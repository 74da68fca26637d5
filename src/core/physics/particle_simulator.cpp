#include "physics/particle_simulator.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/QR>

#include "physics/motion_start.h"

namespace rotatebook::physics {
namespace {

constexpr std::size_t kParticles = 8;
// Least kinetic energy that normalisation leaves, as a fraction of the energy at t = 0.
constexpr double kEnergyFloor = 0.1;

Points fromEigen(const Cage& cage) {
  Points points;
  for (int axis = 0; axis < 3; ++axis) {
    for (int q = 0; q < 4; ++q) {
      points.at(axis).at(q) = Lanes{cage(axis, q), cage(axis, q + 4)};
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

void subtractMean(Points& points) {
  for (Octet& components : points) {
    const double mean = sumOf(components) / kParticles;
    for (Lanes& lanes : components) lanes -= mean;
  }
}

// About the point that `arms` start from.
Eigen::Matrix3d inertiaTensor(const Cage& arms, double mass) {
  const Eigen::Matrix3d products = arms * arms.transpose();
  return mass * (products.trace() * Eigen::Matrix3d::Identity() - products);
}

Eigen::Vector3d angularMomentumOf(const Cage& arms, const Cage& velocities, double mass) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < arms.cols(); ++i) sum += arms.col(i).cross(velocities.col(i));
  return mass * sum;
}

}  // namespace

ParticleSimulator::ParticleSimulator(const MotionSettings& settings)
    : positions_(fromEigen(settings.body.corners())),
      velocities_(
          fromEigen(turningVelocities(settings.body.corners(), initialAngularVelocity(settings)))),
      mass_(settings.body.mass / kParticles),
      springs_(positions_, settings.simulation.stiffness,
               settings.simulation.damping * 2 * std::sqrt(settings.simulation.stiffness * mass_)),
      step_(stepOf(settings.simulation.integrator)),
      normalize_(settings.simulation.normalize),
      energy_(kineticEnergy()),
      fit_(settings.body) {}

ParticleSimulator::Step ParticleSimulator::stepOf(Integrator integrator) {
  switch (integrator) {
    case Integrator::SymplecticEuler:
      return &ParticleSimulator::stepSymplecticEuler;
    case Integrator::Verlet:
      return &ParticleSimulator::stepVerlet;
    case Integrator::Rk4:
      return &ParticleSimulator::stepRk4;
    case Integrator::Euler:
    case Integrator::LieEuler:
    case Integrator::Cf4:
    case Integrator::Splitting:
    case Integrator::Suzuki4:
    case Integrator::Midpoint:
    case Integrator::Dmv2:
    case Integrator::Dmv4:
    case Integrator::Dmv6:
      break;  // All but the first are refused before.
  }
  return &ParticleSimulator::stepEuler;
}

void ParticleSimulator::advance(double h, int steps) {
  for (int step = 0; step < steps; ++step) {
    (this->*step_)(h);
    if (!normalize_) continue;
    restoreEnergy();
    restoreCentre();
  }
}

void ParticleSimulator::stepEuler(double h) {
  const Points acceleration = accelerations(velocities_);
  moveTo(plus(positions_, h, velocities_));
  velocities_ = plus(velocities_, h, acceleration);
}

void ParticleSimulator::stepSymplecticEuler(double h) {
  velocities_ = plus(velocities_, h, accelerations(velocities_));
  moveTo(plus(positions_, h, velocities_));
}

void ParticleSimulator::stepVerlet(double h) {
  const Points before = accelerations(velocities_);
  const Points predicted = plus(velocities_, h, before);
  velocities_ = plus(velocities_, h / 2, before);
  moveTo(plus(positions_, h, velocities_));
  velocities_ = plus(velocities_, h / 2, accelerations(predicted));
}

void ParticleSimulator::stepRk4(double h) {
  const Points x = positions_, v1 = velocities_;
  const Points a1 = accelerations(v1);
  moveTo(plus(x, h / 2, v1));
  const Points v2 = plus(v1, h / 2, a1);
  const Points a2 = accelerations(v2);
  moveTo(plus(x, h / 2, v2));
  const Points v3 = plus(v1, h / 2, a2);
  const Points a3 = accelerations(v3);
  moveTo(plus(x, h, v3));
  const Points v4 = plus(v1, h, a3);
  const Points a4 = accelerations(v4);

  const Points outer = plus(v1, 1, v4), inner = plus(v2, 1, v3);
  moveTo(plus(plus(x, h / 6, outer), h / 3, inner));
  velocities_ = plus(velocities_, h / 6, plus(a1, 1, a4));
  velocities_ = plus(velocities_, h / 3, plus(a2, 1, a3));
}

Points ParticleSimulator::accelerations(const Points& velocities) const {
  Points result = springs_.forces(velocities);
  const double inverse = 1 / mass_;
  for (Octet& components : result) {
    for (Lanes& lanes : components) lanes *= inverse;
  }
  return result;
}

void ParticleSimulator::moveTo(const Points& positions) {
  positions_ = positions;
  springs_.moveTo(positions_);
}

double ParticleSimulator::kineticEnergy() const {
  return mass_ / 2 * squaredNormOf(velocities_);
}

void ParticleSimulator::restoreEnergy() {
  const double wanted = std::max(energy_ - springs_.energy(), kEnergyFloor * energy_);
  const double factor = std::sqrt(wanted / kineticEnergy());
  for (Octet& components : velocities_) {
    for (Lanes& lanes : components) lanes *= factor;
  }
}

// The springs needn't know: they depend on differences alone.
void ParticleSimulator::restoreCentre() {
  subtractMean(positions_);
  subtractMean(velocities_);
}

BodyState ParticleSimulator::state() const {
  BodyState result;
  const Cage cage = toEigen(positions_);
  result.worldFromBody = fit_.worldFromBody(cage);
  result.cage = cage;
  const Cage arms = cage.colwise() - cage.rowwise().mean().eval();
  const Eigen::Matrix3d inertia = inertiaTensor(arms, mass_);
  result.angularMomentum = angularMomentumOf(arms, toEigen(velocities_), mass_);
  // The smallest solution, which stays finite where the particles lie on one line and their inertia
  // is singular.
  result.angularVelocity = inertia.completeOrthogonalDecomposition().solve(result.angularMomentum);
  result.kinetic = kineticEnergy();
  result.potential = springs_.energy();
  result.rotational = result.angularVelocity.dot(result.angularMomentum) / 2;
  return result;
}

}  // namespace rotatebook::physics
