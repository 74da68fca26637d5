#include "physics/particle_simulator.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Geometry>
#include <Eigen/QR>

namespace rotatebook::physics {
namespace {

constexpr std::size_t kParticles = 8;
// Least kinetic energy that normalisation leaves, as a fraction of the energy at t = 0.
constexpr double kEnergyFloor = 0.1;

using Point = std::array<double, 3>;

struct Pair {
  std::size_t i, j;
};

constexpr std::array<Pair, 28> allPairs() {
  std::array<Pair, 28> pairs{};
  std::size_t n = 0;
  for (std::size_t i = 0; i < kParticles; ++i) {
    for (std::size_t j = i + 1; j < kParticles; ++j) pairs[n++] = {i, j};
  }
  return pairs;
}

constexpr std::array<Pair, 28> kPairs = allPairs();

Point difference(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double length(const Point& a) {
  return std::sqrt(dot(a, a));
}

void addScaled(Point& sum, double factor, const Point& a) {
  for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += factor * a[axis];
}

void subtractMean(std::array<Point, kParticles>& points) {
  Point sum{};
  for (const Point& point : points) addScaled(sum, 1, point);
  for (Point& point : points) addScaled(point, -1.0 / kParticles, sum);
}

Point fromEigen(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

Corners toEigen(const std::array<Point, kParticles>& points) {
  return Corners(Eigen::Map<const Corners>(points[0].data()));
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

}  // namespace

ParticleSimulator::ParticleSimulator(const MotionSettings& settings)
    : mass_(settings.body.mass / kParticles),
      stiffness_(settings.simulation.stiffness),
      damping_(settings.simulation.damping * 2 * std::sqrt(stiffness_ * mass_)),
      normalize_(settings.simulation.normalize) {
  const Corners corners = settings.body.corners();
  const Eigen::Vector3d angularVelocity = initialAngularVelocity(settings);
  for (std::size_t i = 0; i < kParticles; ++i) {
    const Eigen::Vector3d corner = corners.col(static_cast<Eigen::Index>(i));
    positions_[i] = fromEigen(corner);
    velocities_[i] = fromEigen(angularVelocity.cross(corner));
  }
  for (std::size_t n = 0; n < kPairs.size(); ++n) {
    restLengths_[n] = length(difference(positions_[kPairs[n].i], positions_[kPairs[n].j]));
  }
  energy_ = kineticEnergy();
}

void ParticleSimulator::advance(double h) {
  const Points force = forces();
  for (std::size_t i = 0; i < kParticles; ++i) {
    addScaled(positions_[i], h, velocities_[i]);
    addScaled(velocities_[i], h / mass_, force[i]);
  }
  if (!normalize_) return;
  restoreEnergy();
  restoreCentre();
}

ParticleSimulator::Points ParticleSimulator::forces() const {
  Points force{};
  for (std::size_t n = 0; n < kPairs.size(); ++n) {
    const auto [i, j] = kPairs[n];
    const Point d = difference(positions_[i], positions_[j]);
    const double l = length(d);
    const double inverse = 1 / l;
    const double lengthening = dot(d, difference(velocities_[i], velocities_[j])) * inverse;
    const double pull = -stiffness_ * (l - restLengths_[n]) - damping_ * lengthening;
    addScaled(force[i], pull * inverse, d);
    addScaled(force[j], -pull * inverse, d);
  }
  return force;
}

double ParticleSimulator::kineticEnergy() const {
  double sum = 0;
  for (const Point& velocity : velocities_) sum += dot(velocity, velocity);
  return mass_ / 2 * sum;
}

double ParticleSimulator::potentialEnergy() const {
  double sum = 0;
  for (std::size_t n = 0; n < kPairs.size(); ++n) {
    const auto [i, j] = kPairs[n];
    const double stretch = length(difference(positions_[i], positions_[j])) - restLengths_[n];
    sum += stretch * stretch;
  }
  return stiffness_ / 2 * sum;
}

void ParticleSimulator::restoreEnergy() {
  const double wanted = std::max(energy_ - potentialEnergy(), kEnergyFloor * energy_);
  const double factor = std::sqrt(wanted / kineticEnergy());
  for (Point& velocity : velocities_) {
    for (double& component : velocity) component *= factor;
  }
}

void ParticleSimulator::restoreCentre() {
  subtractMean(positions_);
  subtractMean(velocities_);
}

BodyState ParticleSimulator::state() const {
  BodyState result;
  result.corners = toEigen(positions_);
  const Corners arms = result.corners.colwise() - result.corners.rowwise().mean().eval();
  const Eigen::Matrix3d inertia = inertiaTensor(arms, mass_);
  result.angularMomentum = angularMomentumOf(arms, toEigen(velocities_), mass_);
  // The smallest solution, which stays finite where the particles lie on one line and their inertia
  // is singular.
  result.angularVelocity = inertia.completeOrthogonalDecomposition().solve(result.angularMomentum);
  result.kinetic = kineticEnergy();
  result.potential = potentialEnergy();
  result.rotational = result.angularVelocity.dot(result.angularMomentum) / 2;
  return result;
}

}  // namespace rotatebook::physics
