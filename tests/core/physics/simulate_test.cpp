#include "physics/simulate.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "physics/measure/exact_tilt.h"
#include "physics/scenarios.h"

namespace rotatebook::physics {
namespace {

using Eigen::Vector3d;
using ::testing::HasSubstr;

constexpr double kSameMotionBound = 1e-8;  // [rad]; measured 5.5e-10
constexpr double kStiffnessBound =
    2e-3;  // [rad], [rad/s], [kg m^2/s]; measured 1.3e-4, 3.7e-4, 7.3e-7

double angleBetween(const Sample& a, const Sample& b) {
  return a.attitude.angularDistance(b.attitude);
}

// Advances a second simulator to sample `n` by hand.
BodyState stateAtSample(const MotionSettings& settings, std::size_t n) {
  const auto simulator = makeSimulator(settings);
  const double h = settings.simulation.timePerFrame / settings.simulation.substeps;
  const std::size_t steps = n * static_cast<std::size_t>(settings.simulation.substeps);
  for (std::size_t step = 0; step < steps; ++step) simulator->advance(h, 1);
  return simulator->state();
}

double farthestCorner(const body::Cage& corners) {
  return corners.colwise().norm().maxCoeff();
}

Scenario exploding() {
  return {.model = Model::Particles, .slant = 0.001, .normalize = false, .damping = 0};
}

TEST(Simulate, TakesASampleEachIntervalFromTheStart) {
  MotionSettings settings = spinning(Model::Quaternion, {1, 2, 3}, 0.1);
  settings.simulation.substeps = 7;
  const Trajectory trajectory = simulate(settings, 50);
  ASSERT_EQ(trajectory.samples.size(), 50U);
  EXPECT_EQ(trajectory.interval, 0.1);
  EXPECT_FALSE(trajectory.divergedAt);
  for (int n = 0; n < 50; ++n)
    EXPECT_EQ(trajectory.samples[static_cast<std::size_t>(n)].time, n * 0.1);
  EXPECT_EQ(trajectory.samples.front().cage, settings.body.corners());
  EXPECT_GE(trajectory.samples.front().attitude.w(), 0);
}

TEST(Simulate, DividesTheIntervalIntoSubsteps) {
  for (const Model model : {Model::Particles, Model::Matrix, Model::Quaternion}) {
    MotionSettings settings = spinning(model, {1, 2, 3}, 0.01);
    settings.simulation.substeps = 7;
    const Trajectory trajectory = simulate(settings, 6);
    EXPECT_EQ(trajectory.samples[5].cage, drawnCage(stateAtSample(settings, 5), settings.body));
    settings.simulation.substeps = 8;
    EXPECT_NE(trajectory.samples[5].cage, simulate(settings, 6).samples[5].cage);
  }
}

/// All that a simulator has, moved by two nudges on the way.
MotionSettings jiggled(Model model) {
  MotionSettings settings = spinning(model, {0.4, -0.3, 5}, 0.1);
  settings.simulation.integrator = defaultIntegrator(model);
  settings.simulation.substeps = 64;
  settings.simulation.normalizeEvery = 3;
  settings.nudges = {{0.33, SpinKind::AngularVelocity, {0.5, 0.2, -0.3}, Nudge::Axes::Body},
                     {0.7, SpinKind::AngularMomentum, {0.002, 0, 0.001}, Nudge::Axes::World}};
  return settings;
}

TEST(Simulate, IsNotChangedBySamplesBetweenSteps) {
  for (const Model model : {Model::Particles, Model::Matrix, Model::Quaternion, Model::Exact}) {
    const MotionSettings settings = jiggled(model);
    std::vector<double> times;
    for (int n = 0; n < 100; ++n) {
      times.push_back(n / 10 * 0.1);
      times.back() += n % 10 * 0.01;
    }
    const auto even = simulate(settings, 10).samples, all = simulate(settings, times).samples;
    ASSERT_EQ(all.size(), 100U);
    for (std::size_t n = 0; n < 10; ++n) {
      EXPECT_EQ(all[10 * n].time, even[n].time);
      EXPECT_EQ(all[10 * n].cage, even[n].cage);
      EXPECT_EQ(all[10 * n].angularMomentum, even[n].angularMomentum);
    }
  }
}

TEST(Simulate, TakesTheSameSamplesWithoutKeepingOrComparingThem) {
  for (const Model model : {Model::Particles, Model::Quaternion, Model::Exact}) {
    const MotionSettings settings = spinning(model, {5, 0.1, 0.1}, 0.01);
    const Trajectory kept = simulate(settings, 200);
    Simulation simulation(settings, Compared::No);
    for (const Sample& sample : std::span(kept.samples).subspan(1)) {
      const auto once = simulation.sampleOnce(sample.time);
      ASSERT_TRUE(once);
      EXPECT_EQ(once->attitude.coeffs(), sample.attitude.coeffs());
      EXPECT_EQ(once->tiltDeg, sample.tiltDeg);
      EXPECT_EQ(once->halfTurns, sample.halfTurns);
      EXPECT_EQ(once->total(), sample.total());
      EXPECT_EQ(once->errorDeg, 0);
    }
    EXPECT_EQ(simulation.trajectory().samples.size(), 1U);
  }
}

TEST(ExactTilt, IsThatOfTheSamples) {
  constexpr double kBound = 1e-10;  // [degrees]; measured 4.3e-14
  double largest = 0;
  for (const Vector3d& spin : {Vector3d(5, 1e-3, 1e-3), Vector3d(1, 4, 2), Vector3d(0, 0, 3)}) {
    MotionSettings settings = spinning(Model::Exact, spin, 0.1);
    settings.nudges = {{.at = 7.03, .value = {0.5, -1, 0.3}}};
    const ExactTilt tilt(settings);
    for (const Sample& sample : simulate(settings, 200).samples)
      largest = std::max(largest, std::abs(tilt.degAt(sample.time) - sample.tiltDeg));
  }
  EXPECT_LE(largest, kBound);
}

TEST(Simulate, FollowsTheMotionBetweenSteps) {
  constexpr double kBound = 1e-8;       // [degrees]; measured 6.2e-10
  constexpr double kCageBound = 1e-10;  // [m]; measured 4.9e-12
  MotionSettings settings = jiggled(Model::Quaternion);
  const std::vector<double> times{0, 1e-3, 0.329, 0.331, 0.4999999, 0.77, 0.9};
  const Trajectory steps = simulate(settings, times);
  for (const Sample& sample : steps.samples) EXPECT_LT(sample.errorDeg, kBound) << sample.time;
  settings.simulation.model = Model::Exact;
  const Trajectory exact = simulate(settings, times);
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_EQ(steps.samples[i].time, times[i]);
    EXPECT_EQ(exact.samples[i].errorDeg, 0);
    EXPECT_LT((exact.samples[i].cage - steps.samples[i].cage).norm(), kCageBound) << times[i];
  }
}

TEST(Simulate, EndsBeforeTheSampleThatLiesTooFarOut) {
  const MotionSettings settings = settingsOf(exploding());
  const Trajectory trajectory = simulate(settings, 200);
  const std::size_t end = trajectory.samples.size();
  ASSERT_LT(end, 200U);
  ASSERT_TRUE(trajectory.divergedAt);
  EXPECT_EQ(*trajectory.divergedAt, static_cast<double>(end) * trajectory.interval);
  const double farthest = 20 * settings.body.largestDimension();
  EXPECT_LE(farthestCorner(trajectory.samples.back().cage), farthest);
  EXPECT_GT(farthestCorner(stateAtSample(settings, end).cage.value()), farthest);
}

TEST(Simulate, EndsBeforeANumberThatIsNotFinite) {
  Scenario scenario = exploding();
  scenario.eta = 0.1;
  scenario.substeps = 1000;
  const Trajectory trajectory = simulate(settingsOf(scenario), 9);
  EXPECT_EQ(trajectory.samples.size(), 1U);
  EXPECT_EQ(*trajectory.divergedAt, trajectory.interval);
  EXPECT_FALSE(stateAtSample(settingsOf(scenario), 1).cage->allFinite());
}

TEST(Simulate, HasOnlyFiniteSamplesOfEveryExplosion) {
  for (const Model model : {Model::Particles, Model::Matrix, Model::Quaternion}) {
    for (const double eta : {0.1, 1.0, 1e3, 1e100}) {
      Scenario scenario{
          .model = model, .slant = 0.5, .normalize = false, .eta = eta, .substeps = 1};
      const Trajectory trajectory = simulate(settingsOf(scenario), 2000);
      EXPECT_TRUE(trajectory.divergedAt) << eta;
      const Sample& last = trajectory.samples.back();
      EXPECT_TRUE(
          std::isfinite(last.tiltDeg + last.stretchMax + last.total() + last.attitude.norm()));
    }
  }
}

TEST(Simulate, RefusesASpinWhoseEnergyOverflows) {
  try {
    simulate(spinning(Model::Quaternion, {1e200, 0, 0}, 0.1), 5);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("too large"));
  }
}

TEST(Simulate, RefusesATiltTowardTheSpin) {
  MotionSettings settings = spinning(Model::Particles, {1, 0, 0}, 0.1);
  settings.initial.tilt = Tilt{0.1, 0};
  EXPECT_THROW(simulate(settings, 5), InputError);
}

TEST(Simulate, MakesTheSameMotionOfAllModels) {
  MotionSettings settings = spinning(Model::Quaternion, {1.1, -2.3, -3.7}, 0.01);
  settings.simulation.substeps = 2000;
  settings.simulation.stiffness = 20000;
  const Sample quaternion = simulate(settings, 101).samples.back();
  settings.simulation.model = Model::Matrix;
  const Sample matrix = simulate(settings, 101).samples.back();
  settings.simulation.model = Model::Particles;
  const Sample particles = simulate(settings, 101).samples.back();

  EXPECT_LT(angleBetween(quaternion, matrix), kSameMotionBound);
  EXPECT_LT(angleBetween(quaternion, particles), kStiffnessBound);
  EXPECT_GT(quaternion.attitude.angularDistance(Eigen::Quaterniond::Identity()), 1);
  EXPECT_LT((quaternion.angularVelocity - particles.angularVelocity).norm(), kStiffnessBound);
  EXPECT_LT((3 * quaternion.angularMomentum - particles.angularMomentum).norm(), kStiffnessBound);
}

}  // namespace
}  // namespace rotatebook::physics
