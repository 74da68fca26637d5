#include "physics/nudge.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "physics/integrators/integrator_table.h"
#include "physics/nudged_rotation.h"
#include "physics/scenarios.h"

namespace rotatebook::physics {
namespace {

using Eigen::Vector3d;

constexpr int kFrames = 240;
constexpr double kInterval = 1.0 / 60;  // [s]

MotionSettings nudged(Model model, Integrator integrator, std::vector<Nudge> nudges) {
  MotionSettings settings = spinning(model, {0.4, -0.3, 5}, kInterval);
  settings.simulation.integrator = integrator;
  settings.simulation.substeps = 64;
  settings.nudges = std::move(nudges);
  return settings;
}

/// Two within one step, one within another, and one at the end of a frame.
std::vector<Nudge> someNudges() {
  return {{1.0001, SpinKind::AngularVelocity, {0.5, 0.2, -0.3}, Nudge::Axes::Body},
          {1.00015, SpinKind::AngularMomentum, {0.002, 0, 0.001}, Nudge::Axes::World},
          {2.34567, SpinKind::AngularVelocity, {-1, 0.4, 0}, Nudge::Axes::World},
          {60 * kInterval * 3, SpinKind::AngularMomentum, {0, -0.003, 0}, Nudge::Axes::Body}};
}

double largestErrorDeg(const MotionSettings& settings) {
  const Trajectory trajectory = simulate(settings, kFrames);
  return std::ranges::max(trajectory.samples, {}, &Sample::errorDeg).errorDeg;
}

// [rad/s] and [kg m^2/s]
struct Jump {
  Vector3d velocity, momentum;
  Eigen::Quaterniond attitude;
};

/// The changes of w and L between the samples on both sides of 2 s, along world axes.
Jump jumpAt2Seconds(Model model, const Nudge& nudge,
                    const std::optional<Eigen::Matrix3d>& inertia = {}) {
  MotionSettings settings = nudged(model, defaultIntegrator(model), {});
  settings.inertia = inertia;
  settings.simulation.timePerFrame = 2;
  settings.simulation.substeps = 20000;
  const Sample before = simulate(settings, 2).samples.back();
  settings.nudges = {nudge};
  const Sample after = simulate(settings, 2).samples.back();
  return {after.angularVelocity - before.angularVelocity,
          after.angularMomentum - before.angularMomentum, after.attitude};
}

class NudgeOfModel : public ::testing::TestWithParam<Model> {};

TEST_P(NudgeOfModel, AddsItsAngularMomentumInWorldAxes) {
  const Vector3d added(0.001, -0.002, 0.003);
  const Jump jump =
      jumpAt2Seconds(GetParam(), {2, SpinKind::AngularMomentum, added, Nudge::Axes::World});
  EXPECT_LT((jump.momentum - added).norm(), 1e-16);  // measured 9.5e-18
}

TEST_P(NudgeOfModel, AddsItsAngularVelocityInWorldAxes) {
  const Vector3d added(0.1, -0.2, 0.3);
  const Jump jump =
      jumpAt2Seconds(GetParam(), {2, SpinKind::AngularVelocity, added, Nudge::Axes::World});
  EXPECT_LT((jump.velocity - added).norm(), 1e-13);  // measured 4.6e-15
}

TEST_P(NudgeOfModel, AddsItsAngularVelocityInBodyAxes) {
  const Vector3d added(0.1, -0.2, 0.3);
  const Jump inBody =
      jumpAt2Seconds(GetParam(), {2, SpinKind::AngularVelocity, added, Nudge::Axes::Body});
  EXPECT_LT((inBody.velocity - inBody.attitude * added).norm(), 1e-13);  // measured 2.6e-15
  EXPECT_GT((inBody.velocity - added).norm(), 0.1) << "the body has turned";
}

INSTANTIATE_TEST_SUITE_P(All, NudgeOfModel,
                         ::testing::Values(Model::Particles, Model::Matrix, Model::Quaternion,
                                           Model::Exact));

TEST(Nudge, AddsAlongTheAxesItNamesWhereTheBodysArentPrincipal) {
  Eigen::Matrix3d inertia;
  inertia << 0.004, -0.001, 0.00125, -0.001, 0.00475, 0.00025, 0.00125, 0.00025, 0.003625;
  const Vector3d added(0.001, -0.002, 0.003);
  for (const Model model : {Model::Matrix, Model::Quaternion, Model::Exact}) {
    const Jump inWorld =
        jumpAt2Seconds(model, {2, SpinKind::AngularMomentum, added, Nudge::Axes::World}, inertia);
    EXPECT_LT((inWorld.momentum - added).norm(), 1e-16);  // measured 2.8e-18
    const Jump inBody =
        jumpAt2Seconds(model, {2, SpinKind::AngularMomentum, added, Nudge::Axes::Body}, inertia);
    EXPECT_LT((inBody.momentum - inBody.attitude * added).norm(), 1e-16);  // measured 3.0e-18
  }
}

TEST_P(NudgeOfModel, AnAttitudeAtTheStartTurnsTheWholeMotion) {
  const Eigen::Quaterniond turn = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized();
  MotionSettings settings = nudged(GetParam(), defaultIntegrator(GetParam()), someNudges());
  const Trajectory upright = simulate(settings, kFrames);
  settings.initial.attitude = Eigen::Vector4d(0.6, -1, 1.4, 0.4);
  for (Nudge& nudge : settings.nudges)
    if (nudge.axes == Nudge::Axes::World) nudge.value = turn * nudge.value;
  const Trajectory turned = simulate(settings, kFrames);
  for (std::size_t n = 0; n < upright.samples.size(); ++n) {
    const Sample &one = upright.samples[n], &other = turned.samples[n];
    const double bound = 1e-12;  // measured 4.4e-13 of errorDeg, 5.9e-14 of the others
    EXPECT_LT((turn * one.attitude).angularDistance(other.attitude), bound);
    EXPECT_LT((turn * one.angularVelocity - other.angularVelocity).norm(), bound);
    EXPECT_LT((turn * one.angularMomentum - other.angularMomentum).norm(), bound);
    EXPECT_LT((turn.toRotationMatrix() * one.cage - other.cage).norm(), bound);
    EXPECT_NEAR(one.tiltDeg, other.tiltDeg, bound);
    EXPECT_NEAR(one.errorDeg, other.errorDeg, bound);
  }
}

TEST(Nudge, KeepsTheOrderOfEachIntegrator) {
  for (const IntegratorRow& row : integratorTable()) {
    if (!isFor(Model::Quaternion, row.integrator) || row.order == 0) continue;
    MotionSettings settings = nudged(Model::Quaternion, row.integrator, someNudges());
    settings.simulation.substeps = 2;
    const double coarse = largestErrorDeg(settings);
    settings.simulation.substeps = 4;
    const double ratio = coarse / largestErrorDeg(settings);
    EXPECT_GT(ratio, 0.9 * std::pow(2, row.order)) << row.word;  // measured 0.97 and more
  }
}

TEST(Nudge, LeavesTheExactMotionAsFreeFromEachToTheNext) {
  const MotionSettings settings = nudged(Model::Exact, Integrator::Rk4, someNudges());
  const Trajectory trajectory = simulate(settings, kFrames);
  const auto& samples = trajectory.samples;
  int jumps = 0;
  for (std::size_t n = 1; n < samples.size(); ++n) {
    jumps += samples[n].angularMomentum != samples[n - 1].angularMomentum;
    const double turned =
        2 * samples[n].attitude.angularDistance(samples[n - 1].attitude) / kInterval;
    EXPECT_LT(turned, 20) << "the attitude jumps at " << samples[n].time;
  }
  EXPECT_EQ(jumps, 3);
}

TEST(Nudge, LeavesTheStepInWhichItFallsOneStep) {
  for (const Model model : {Model::Matrix, Model::Particles}) {
    MotionSettings settings = nudged(model, Integrator::Euler, {});
    settings.nudges = {{0.10003, SpinKind::AngularVelocity, {0.1, 0, 0}, Nudge::Axes::Body}};
    settings.simulation.timePerFrame = 0.1;
    settings.simulation.substeps = 200;
    settings.simulation.normalizeEvery = 200;
    for (const Sample& sample : simulate(settings, 10).samples) {
      if (model == Model::Matrix) {
        EXPECT_LT(std::fabs(sample.stretchMax - 1), 1e-14) << sample.time;  // measured 4.4e-16
      } else if (sample.time > 0.15) {  // Later the energy is that just after the nudge.
        EXPECT_LT(sample.centreDrift(), 1e-15) << sample.time;
      }
    }
  }
}

// A frame of a finer clip splits the same steps.
TEST(Nudge, FallsAtTheSameMomentWhateverTheFrames) {
  MotionSettings settings = nudged(Model::Quaternion, Integrator::Rk4, someNudges());
  const Sample coarse = simulate(settings, kFrames).samples.back();
  settings.simulation.timePerFrame /= 4;
  settings.simulation.substeps /= 4;
  const Sample fine = simulate(settings, 4 * (kFrames - 1) + 1).samples.back();
  EXPECT_LT(coarse.attitude.angularDistance(fine.attitude), 1e-13);  // measured 2.4e-15
}

TEST(Nudge, ChangesTheEnergyThatNormalisingRestores) {
  MotionSettings settings = nudged(Model::Particles, Integrator::Euler, {});
  settings.simulation.stiffness = 5000;
  settings.nudges = {{1, SpinKind::AngularVelocity, {0, 0, 2}, Nudge::Axes::Body}};
  const Trajectory trajectory = simulate(settings, kFrames);
  const double ratio = trajectory.samples.back().total() / trajectory.samples.front().total();
  EXPECT_NEAR(ratio, std::pow(7.0 / 5, 2), 0.02);  // measured 0.0054, as the springs give way
}

TEST(Nudge, AboutTheMiddleAxisStartsATumbling) {
  MotionSettings settings = spinning(Model::Exact, {4, 0, 0}, kInterval);
  EXPECT_EQ(simulate(settings, 900).samples.back().halfTurns, 0);
  settings.nudges = {{1, SpinKind::AngularVelocity, {0, 0.05, 0}, Nudge::Axes::Body}};
  EXPECT_GT(simulate(settings, 900).samples.back().halfTurns, 2);
}

}  // namespace
}  // namespace rotatebook::physics
