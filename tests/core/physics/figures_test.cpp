// The effects that the paper's figures show, as numbers of the plain motions behind them. Angles
// are spin rate * time.
#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "physics/scenarios.h"

namespace rotatebook::physics {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

template <typename Predicate>
double firstAngle(const Trajectory& trajectory, Predicate holds) {
  const auto found = std::ranges::find_if(trajectory.samples, holds);
  return found == trajectory.samples.end() ? kNever : kSpinRate * found->time;
}

double angleOfHalfTurn(const Trajectory& trajectory, int count) {
  return firstAngle(trajectory, [=](const Sample& sample) { return sample.halfTurns >= count; });
}

double angleOfDivergence(const Trajectory& trajectory) {
  return trajectory.divergedAt ? kSpinRate * *trajectory.divergedAt : kNever;
}

template <typename Value>
double largest(const Trajectory& trajectory, Value value) {
  double result = -kNever;
  for (const Sample& sample : trajectory.samples) result = std::max(result, value(sample));
  return result;
}

double largestTilt(const Trajectory& trajectory) {
  return largest(trajectory, [](const Sample& sample) { return sample.tiltDeg; });
}

double energyRatioAt(const Trajectory& trajectory, double angle) {
  const auto found = std::ranges::find_if(
      trajectory.samples, [=](const Sample& sample) { return kSpinRate * sample.time >= angle; });
  return found->total() / trajectory.samples.front().total();
}

void expectTumbling(const Trajectory& trajectory) {
  EXPECT_NEAR(angleOfHalfTurn(trajectory, 1), 12.8, 0.2);  // measured 12.8
  EXPECT_NEAR(angleOfHalfTurn(trajectory, 2), 25.3, 0.5);  // measured 25.5 and 25.1
  EXPECT_EQ(trajectory.samples.back().halfTurns, 5);       // up to 60
  EXPECT_GT(largestTilt(trajectory), 177);                 // measured 177.9 and 177.6
}

TEST(Figure3, ParticlesSpinSteadilyAboutZ) {
  const Trajectory trajectory = simulate(
      {.model = Model::Particles, .axis = 2, .slant = 0.01, .kappa = 1435, .eta = 0.0014}, 30);
  EXPECT_NEAR(largestTilt(trajectory), 1.49, 0.01);  // measured 1.4946
  const double inSprings =
      largest(trajectory, [](const Sample& sample) { return sample.potential / sample.total(); });
  EXPECT_NEAR(inSprings, 1.8e-4, 1e-5);  // measured 1.81e-4
}

TEST(Figure4, ParticlesSpinSteadilyAboutY) {
  const Trajectory trajectory = simulate(
      {.model = Model::Particles, .axis = 1, .slant = 0.01, .kappa = 570, .eta = 0.0022}, 30);
  EXPECT_NEAR(largestTilt(trajectory), 0.85, 0.01);  // measured 0.8477
}

TEST(Figure5, ParticlesTumbleAboutX) {
  expectTumbling(simulate({.model = Model::Particles, .slant = 0.001}, 60));
}

TEST(Figure5, ParticlesTumbleAboutXByRoundingAlone) {
  const Trajectory trajectory = simulate({.model = Model::Particles}, 100);
  EXPECT_GT(angleOfHalfTurn(trajectory, 1), 40);  // measured 61
  EXPECT_LT(angleOfHalfTurn(trajectory, 1), 90);
}

TEST(Figure6, UndampedParticlesTurnAllRotationIntoVibration) {
  for (int axis = 0; axis < 3; ++axis) {
    const Trajectory trajectory =
        simulate({.model = Model::Particles, .axis = axis, .slant = 0.001, .damping = 0}, 6);
    const Sample& start = trajectory.samples.front();
    const double lost = firstAngle(
        trajectory, [&](const Sample& sample) { return sample.rotational < 1e-3 * start.total(); });
    EXPECT_GT(lost, 0.9) << axis;  // measured 1.06 to 1.14
    EXPECT_LT(lost, 3) << axis;
    const Sample& end = trajectory.samples.back();
    EXPECT_LT(end.rotational / start.total(), 1e-3) << axis;
    EXPECT_LT(end.angularMomentum.norm() / start.angularMomentum.norm(), 1e-3) << axis;
    EXPECT_GT(end.total() / start.total(), 0.99) << axis;
  }
}

TEST(Figure7, UnnormalisedParticlesGainEnergyUntilTheyExplode) {
  const Scenario scenario{.model = Model::Particles,
                          .slant = 0.001,
                          .normalize = false,
                          .kappa = 84,
                          .eta = 0.0138,
                          .substeps = 5};
  const Trajectory trajectory = simulate(scenario, 60);
  EXPECT_NEAR(energyRatioAt(trajectory, 25), 3.1, 0.1);    // measured 3.11
  EXPECT_NEAR(angleOfDivergence(trajectory), 40, 1);       // measured 40.0
  EXPECT_NEAR(angleOfHalfTurn(trajectory, 1), 11.7, 0.2);  // measured 11.7
  EXPECT_NEAR(angleOfHalfTurn(trajectory, 7), 36.1, 0.5);  // measured 36.1
}

TEST(Figure7, StifferParticlesExplodeLater) {
  const Scenario scenario{.model = Model::Particles,
                          .slant = 0.001,
                          .normalize = false,
                          .kappa = 190,
                          .eta = 0.0092,
                          .substeps = 5};
  const Trajectory trajectory = simulate(scenario, 70);
  EXPECT_NEAR(energyRatioAt(trajectory, 16), 1.4, 0.1);  // measured 1.41
  EXPECT_NEAR(energyRatioAt(trajectory, 33), 2.6, 0.1);  // measured 2.56
  EXPECT_NEAR(energyRatioAt(trajectory, 50), 16, 1);     // measured 16.2
  EXPECT_NEAR(angleOfDivergence(trajectory), 55, 1);     // measured 55.2
}

TEST(Figure8, UndampedUnnormalisedParticlesExplodeSooner) {
  const Scenario scenario{
      .model = Model::Particles, .slant = 0.001, .normalize = false, .damping = 0};
  EXPECT_NEAR(angleOfDivergence(simulate(scenario, 10)), 2.3, 0.3);  // measured 2.28
}

TEST(Figure9, RigidModelsTumbleAboutX) {
  const Trajectory matrix = simulate({.model = Model::Matrix, .slant = 0.001}, 60);
  const Trajectory quaternion = simulate({.model = Model::Quaternion, .slant = 0.001}, 60);
  expectTumbling(matrix);
  expectTumbling(quaternion);
  double worst = 0;
  for (std::size_t n = 0; n < matrix.samples.size(); ++n) {
    worst = std::max(worst, std::abs(matrix.samples[n].tiltDeg - quaternion.samples[n].tiltDeg));
  }
  EXPECT_LT(worst, 0.01);  // [degrees]; measured 2.2e-3
}

TEST(Figure9, LargeStepsEndInASpinAboutAnotherAxis) {
  const Scenario scenario{.model = Model::Matrix, .slant = 0.001, .eta = 0.069, .substeps = 1};
  const Trajectory trajectory = simulate(scenario, 400);
  EXPECT_EQ(trajectory.samples.back().halfTurns, 10);
  EXPECT_LT(angleOfHalfTurn(trajectory, 10), 50);  // measured 45.9
  const Sample& end = trajectory.samples.back();
  const Eigen::Vector3d spunAbout = end.attitude.conjugate() * end.angularMomentum.normalized();
  EXPECT_GT(std::abs(spunAbout.y()), 0.999);  // the axis of the smallest moment of inertia
  EXPECT_NEAR(end.stretchMax, 1, 1e-12);
}

TEST(Figure10, UnnormalisedMatrixGrows) {
  Scenario scenario{
      .model = Model::Matrix, .slant = 0.001, .normalize = false, .eta = 0.0115, .substeps = 5};
  const Sample fine = simulate(scenario, 41).samples.back();
  EXPECT_NEAR(fine.stretchMax, 1.25, 0.01);  // measured 1.25
  EXPECT_NEAR(fine.stretchMin, 1.16, 0.01);  // measured 1.16
  scenario.eta = 0.057;
  scenario.substeps = 1;
  const Trajectory coarse = simulate(scenario, 40);
  EXPECT_NEAR(angleOfDivergence(coarse), 30.7, 0.5);  // measured 30.7
  const double doubled =
      firstAngle(coarse, [](const Sample& sample) { return sample.stretchMax > 1.9; });
  EXPECT_NEAR(doubled, 23, 1);  // measured 22.6
}

TEST(Figure11, UnnormalisedQuaternionGrowsUntilItBlowsUp) {
  Scenario scenario{
      .model = Model::Quaternion, .slant = 0.001, .normalize = false, .eta = 0.057, .substeps = 1};
  EXPECT_NEAR(angleOfDivergence(simulate(scenario, 60)), 26.4, 0.5);  // measured 26.4
  scenario.eta = 0.0115;
  scenario.substeps = 5;
  const Trajectory fine = simulate(scenario, 41);
  EXPECT_FALSE(fine.divergedAt);
  EXPECT_NEAR(largest(fine, [](const Sample& sample) { return sample.stretchMax; }), 1.33,
              0.02);  // measured 1.33
}

TEST(Figure12, UnnormalisedQuaternionBreathesOnceATurn) {
  const Scenario scenario{.model = Model::Quaternion,
                          .axis = 2,
                          .slant = 0.001,
                          .normalize = false,
                          .eta = 0.042,
                          .substeps = 1};
  const Trajectory trajectory = simulate(scenario, 12);
  int peaks = 0;
  for (std::size_t n = 1; n + 1 < trajectory.samples.size(); ++n) {
    const double here = trajectory.samples[n].stretchMax;
    if (here < trajectory.samples[n - 1].stretchMax || here <= trajectory.samples[n + 1].stretchMax)
      continue;
    const double squaredNorm = std::pow(1 + scenario.eta * scenario.eta / 4, n);
    EXPECT_NEAR(here, 1 + 2 * (squaredNorm - 1), 0.01);  // measured 0.006 and 0.003
    ++peaks;
  }
  EXPECT_EQ(peaks, 2);
  for (const Sample& sample : trajectory.samples) EXPECT_NEAR(sample.stretchMin, 1, 1e-6);
}

TEST(RigidModels, NeverTumbleWithoutTilt) {
  for (const Model model : {Model::Matrix, Model::Quaternion}) {
    for (const double eta : {0.0019, 0.069}) {
      const Trajectory trajectory = simulate({.model = model, .eta = eta}, 100);
      EXPECT_EQ(trajectory.samples.back().halfTurns, 0);
      EXPECT_LT(largestTilt(trajectory), 1e-9);  // [degrees]; measured 0
    }
  }
}

TEST(RigidModels, SpinSteadilyAboutTheirStableAxes) {
  for (const Model model : {Model::Matrix, Model::Quaternion}) {
    const double aboutY = largestTilt(simulate({.model = model, .axis = 1, .slant = 0.01}, 60));
    const double aboutZ = largestTilt(simulate({.model = model, .axis = 2, .slant = 0.01}, 60));
    EXPECT_NEAR(aboutY, 0.85, 0.01);  // measured 0.85
    EXPECT_NEAR(aboutZ, 1.67, 0.01);  // measured 1.674, of which Euler's energy error is 0.18
  }
}

}  // namespace
}  // namespace rotatebook::physics
