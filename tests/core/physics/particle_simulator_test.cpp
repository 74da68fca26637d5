#include "physics/particle_simulator.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "physics/integrators/particle_euler.h"
#include "physics/scenarios.h"

namespace rotatebook::physics {
namespace {

using Eigen::Vector3d;

constexpr double kParticleStepBound = 1e-13;   // relative; measured 1.2e-14
constexpr double kFloorBound = 1e-12;          // relative; measured 4e-14
constexpr double kEnergyBound = 1e-14;         // relative; measured 5e-16
constexpr double kMomentumGrowthBound = 0.02;  // relative; measured 0.0101 and 0.0050
constexpr double kCentreBound = 1e-16;         // [m]; measured 2.1e-17

// The equations written once more, each force found by its own particle.
struct ByHand {
  explicit ByHand(const MotionSettings& asked) : settings(asked) {
    const Vector3d spin = initialAngularVelocity(settings);
    const body::Cage corners = settings.body.corners();
    for (const auto& corner : corners.colwise()) {
      rest.push_back(corner);
      velocities.push_back(spin.cross(Vector3d(corner)));
    }
    positions = rest;
    energy = kinetic();
  }

  double mass() const { return settings.body.mass / 8; }
  double stiffness() const { return settings.simulation.stiffness; }

  Vector3d forceOn(std::size_t i) const {
    const double damping = settings.simulation.damping * 2 * std::sqrt(stiffness() * mass());
    Vector3d force = Vector3d::Zero();
    for (std::size_t j = 0; j < 8; ++j) {
      if (j == i) continue;
      const Vector3d toOther = (positions[j] - positions[i]).normalized();
      const double length = (positions[j] - positions[i]).norm();
      const double separating = toOther.dot(velocities[j] - velocities[i]);
      force += stiffness() * (length - (rest[j] - rest[i]).norm()) * toOther;
      force += damping * separating * toOther;
    }
    return force;
  }

  void advance(double h) {
    std::vector<Vector3d> accelerations;
    for (std::size_t i = 0; i < 8; ++i) accelerations.push_back(forceOn(i) / mass());
    for (std::size_t i = 0; i < 8; ++i) positions[i] = positions[i] + h * velocities[i];
    for (std::size_t i = 0; i < 8; ++i) velocities[i] = velocities[i] + h * accelerations[i];
    if (settings.simulation.energyEvery() > 0) restoreEnergy();
    if (settings.simulation.driftEvery() > 0) restoreCentre();
  }

  void restoreEnergy() {
    const double left = energy - potential() < energy / 10 ? energy / 10 : energy - potential();
    const double factor = std::sqrt(left / kinetic());
    for (Vector3d& velocity : velocities) velocity *= factor;
  }

  void restoreCentre() {
    centre(positions);
    centre(velocities);
  }

  static void centre(std::vector<Vector3d>& points) {
    Vector3d mean = Vector3d::Zero();
    for (const Vector3d& point : points) mean += point / 8;
    for (Vector3d& point : points) point -= mean;
  }

  double kinetic() const {
    double sum = 0;
    for (const Vector3d& velocity : velocities) sum += mass() * velocity.squaredNorm() / 2;
    return sum;
  }

  // Each pair twice, hence a quarter in place of a half.
  double potential() const {
    double sum = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      for (std::size_t j = 0; j < 8; ++j) {
        const double stretch = (positions[i] - positions[j]).norm() - (rest[i] - rest[j]).norm();
        sum += stiffness() * stretch * stretch / 4;
      }
    }
    return sum;
  }

  Vector3d angularMomentum() const {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < 8; ++i) sum += mass() * positions[i].cross(velocities[i]);
    return sum;
  }

  MotionSettings settings;
  std::vector<Vector3d> rest, positions, velocities;
  double energy = 0;
};

void compareWithStepsByHand(const MotionSettings& settings) {
  ParticleSimulator simulator(settings, &ParticleEuler::step);
  ByHand expected(settings);
  for (int step = 0; step < 20; ++step) {
    simulator.advance(1e-3, 1);
    expected.advance(1e-3);
  }
  const BodyState state = simulator.state();
  for (int i = 0; i < 8; ++i) {
    EXPECT_LT((state.cage->col(i) - expected.positions[static_cast<std::size_t>(i)]).norm(),
              kParticleStepBound);
  }
  EXPECT_NEAR(state.kinetic / expected.kinetic(), 1, kParticleStepBound);
  EXPECT_NEAR(state.potential / expected.potential(), 1, kParticleStepBound);
  EXPECT_LT((state.angularMomentum - expected.angularMomentum()).norm(), kParticleStepBound);
}

void compareWithStepsByHand(bool normalize, double damping) {
  MotionSettings settings = spinning(Model::Particles, {3, -4, 5}, 1e-3);
  settings.simulation.normalizeEvery = normalize ? 1 : 0;
  settings.simulation.damping = damping;
  settings.simulation.stiffness = 300;
  compareWithStepsByHand(settings);
}

// Relative growth of |L| over an angle of `angle`, about the stable axis z, unnormalised.
double momentumGrowth(double eta, double angle) {
  const Trajectory trajectory = simulate(Scenario{.model = Model::Particles,
                                                  .axis = 2,
                                                  .normalize = false,
                                                  .kappa = 5000,
                                                  .eta = eta,
                                                  .substeps = 10},
                                         angle);
  return trajectory.samples.back().angularMomentum.norm() /
         trajectory.samples.front().angularMomentum.norm();
}

TEST(ParticleSimulator, StepsAsByHand) {
  compareWithStepsByHand(false, 1);
}

TEST(ParticleSimulator, StepsAsByHandWithoutDamping) {
  compareWithStepsByHand(false, 0);
}

TEST(ParticleSimulator, NormalisesAsByHand) {
  compareWithStepsByHand(true, 0.5);
}

TEST(ParticleSimulator, NormalisesTheEnergyAloneAsByHand) {
  MotionSettings settings = spinning(Model::Particles, {3, -4, 5}, 1e-3);
  settings.simulation.normalizeEvery = 0;
  settings.simulation.normalizeEnergyEvery = 1;
  compareWithStepsByHand(settings);
}

// Rounding alone moves the centre: internal forces come in opposite pairs.
TEST(ParticleSimulator, RemovesTheDriftOfTheCentreAlone) {
  MotionSettings settings = spinning(Model::Particles, {2, 3, -4}, 1.0 / 60);
  settings.simulation.substeps = 64;
  settings.simulation.normalizeEvery = 0;
  const auto driftAfter20Seconds = [&] {
    return simulate(settings, 1200).samples.back().centreDrift();
  };
  EXPECT_GT(driftAfter20Seconds(), 1e-14);  // measured 4.5e-14
  settings.simulation.removeDriftEvery = 1;
  EXPECT_LT(driftAfter20Seconds(), 1e-16);  // measured 3.9e-18
}

TEST(ParticleSimulator, MovesByTheOldVelocitiesFirst) {
  MotionSettings settings = spinning(Model::Particles, {0, 0, 2}, 0.5);
  settings.body.size = {2, 4, 6};
  settings.simulation.normalizeEvery = 0;
  ParticleSimulator simulator(settings, &ParticleEuler::step);
  simulator.advance(0.5, 1);
  // At rest length no spring pulls: corner 7 at (1, 2, 3) moves by 0.5 (0, 0, 2) x (1, 2, 3).
  EXPECT_EQ(Vector3d(simulator.state().cage->col(7)), Vector3d(-1, 3, 3));
}

TEST(ParticleSimulator, StartsWithTheSpinAndTheEnergyOfEightParticles) {
  MotionSettings settings = spinning(Model::Particles, {1, 2, 3}, 0.1);
  settings.body = {{1, 2, 3}, 12};
  const BodyState state = ParticleSimulator(settings, &ParticleEuler::step).state();
  EXPECT_LT((state.angularVelocity - Vector3d(1, 2, 3)).norm(), kParticleStepBound);
  EXPECT_LT((state.angularMomentum - Vector3d(39, 60, 45)).norm(), kParticleStepBound * 84);
  EXPECT_NEAR(state.kinetic, 147, kParticleStepBound * 147);
  EXPECT_NEAR(state.rotational, 147, kParticleStepBound * 147);
  EXPECT_EQ(state.potential, 0);
}

TEST(ParticleSimulator, TakesAnAngularMomentumForItsOwnInertia) {
  MotionSettings settings = spinning(Model::Particles, {39, 60, 45}, 0.1);
  settings.body = {{1, 2, 3}, 12};
  settings.initial.kind = InitialSpin::Kind::AngularMomentum;
  const BodyState state = ParticleSimulator(settings, &ParticleEuler::step).state();
  EXPECT_LT((state.angularVelocity - Vector3d(1, 2, 3)).norm(), kParticleStepBound);
}

TEST(ParticleSimulator, HasTheEnergyOfItsStartAfterEachNormalisedStep) {
  const MotionSettings settings = settingsOf({.model = Model::Particles, .slant = 0.1});
  ParticleSimulator simulator(settings, &ParticleEuler::step);
  const double start = simulator.state().kinetic;
  double worst = 0, mostInSprings = 0;
  for (int step = 0; step < 2000; ++step) {
    simulator.advance(settings.simulation.timePerFrame / settings.simulation.substeps, 1);
    const BodyState state = simulator.state();
    worst = std::max(worst, std::abs(state.kinetic + state.potential - start) / start);
    mostInSprings = std::max(mostInSprings, state.potential / start);
  }
  EXPECT_LT(worst, kEnergyBound);
  EXPECT_GT(mostInSprings, 1e-4);  // measured 4e-4: not a motion without springs
}

TEST(ParticleSimulator, LeavesATenthOfItsEnergyWhereSpringsHaveTakenNearlyAll) {
  const MotionSettings settings =
      settingsOf({.model = Model::Particles, .slant = 0.001, .damping = 0});
  ParticleSimulator simulator(settings, &ParticleEuler::step);
  const double start = simulator.state().kinetic;
  int bites = 0;
  for (int step = 0; step < 2000; ++step) {
    simulator.advance(settings.simulation.timePerFrame / settings.simulation.substeps, 1);
    const BodyState state = simulator.state();
    const double floor = std::max(start - state.potential, start / 10);
    EXPECT_NEAR(state.kinetic / floor, 1, kFloorBound) << step;
    if (state.potential > 0.9 * start) ++bites;
  }
  EXPECT_GT(bites, 10);  // measured 473
}

// Without normalisation's centring rounding alone would move it by 4e-16 m.
TEST(ParticleSimulator, KeepsItsCentreInTheOriginWhenNormalised) {
  const MotionSettings settings =
      settingsOf({.model = Model::Particles, .slant = 0.3, .damping = 0, .eta = 0.02});
  ParticleSimulator simulator(settings, &ParticleEuler::step);
  const double h = settings.simulation.timePerFrame / settings.simulation.substeps;
  double farthest = 0;
  for (int step = 0; step < 5000; ++step) {
    simulator.advance(h, 1);
    if (step % 50 == 0) {
      farthest = std::max(farthest, simulator.state().cage->rowwise().mean().norm());
    }
  }
  EXPECT_LT(farthest, kCentreBound);
}

// Explicit Euler turns each particle's momentum by h sum(v x F): on a circle that is a growth of L
// by w^2 h a second.
TEST(ParticleSimulator, GainsAngularMomentumAsExplicitEulerMust) {
  EXPECT_NEAR(std::log(momentumGrowth(0.001, 10)) / (0.001 * 10), 1, kMomentumGrowthBound);
  EXPECT_NEAR(std::log(momentumGrowth(0.0005, 10)) / (0.0005 * 10), 1, kMomentumGrowthBound);
}

TEST(ParticleSimulator, LosesItsVibrationToDamping) {
  Scenario scenario{
      .model = Model::Particles, .axis = 2, .normalize = false, .eta = 1e-5, .substeps = 1000};
  const Sample damped = simulate(scenario, 1).samples.back();
  scenario.damping = 0;
  const Trajectory undamped = simulate(scenario, 1);
  const double start = undamped.samples.front().total();
  // The spin's own tension stays in the springs; what is left beside it is vibration.
  EXPECT_NEAR(damped.rotational / damped.kinetic, 1, 1e-6);
  EXPECT_LT(damped.total() / start, 0.9999);
  EXPECT_GT(undamped.samples.back().total() / start, 1);
}

TEST(ParticleSimulator, HasAFiniteSpinEvenOfParticlesOnALine) {
  MotionSettings settings = spinning(Model::Particles, {5, 0, 3}, 0.1);
  settings.body.size = {1, 1e-170, 1e-170};
  const BodyState state = ParticleSimulator(settings, &ParticleEuler::step).state();
  EXPECT_LT((state.angularVelocity - Vector3d(0, 0, 3)).norm(), kParticleStepBound);
}

}  // namespace
}  // namespace rotatebook::physics
