// Motions of one throw by the update rules of game engines, each of which is the rule that its
// engine documents.
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include "physics/integrator_names.h"
#include "physics/scenarios.h"
#include "rigid/rotation.h"

namespace rotatebook::physics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kStepBound = 1e-13;  // [rad/s] and [m], after 20 steps; measured 5.1e-15
constexpr double kKept = 1e-13;       // relative, after 10 s; measured 5e-15
constexpr double kStep = 1.0 / 60;    // [s]
constexpr int kSteps = 600;           // 10 s

// The book that the engines themselves are measured with, in bench/engines.
MotionSettings thrown(Model model, Integrator integrator) {
  MotionSettings settings = spinning(model, {2 * std::numbers::pi, 0, 0}, kStep);
  settings.body = {{0.15, 0.22, 0.04}, 1};
  settings.initial.tilt = Tilt{0.01, 2};
  settings.simulation.integrator = integrator;
  return settings;
}

class EngineRule : public testing::TestWithParam<Model> {
 protected:
  Trajectory thrownBy(Integrator integrator) const {
    return simulate(thrown(GetParam(), integrator), kSteps + 1);
  }
};

double energyOf(const Trajectory& motion) {
  return motion.samples.back().kinetic / motion.samples.front().kinetic;
}

double momentumOf(const Trajectory& motion) {
  return motion.samples.back().angularMomentum.norm() /
         motion.samples.front().angularMomentum.norm();
}

TEST_P(EngineRule, WithoutTorqueNeverFlips) {
  const Trajectory motion = thrownBy(Integrator::NoGyroscopic);
  EXPECT_NEAR(energyOf(motion), 1, kKept);
  EXPECT_NEAR(momentumOf(motion), 1, kKept);
  EXPECT_EQ(motion.samples.back().halfTurns, 0);
  const Vector3d& start = motion.samples.front().angularVelocity;
  for (const Sample& sample : motion.samples) {
    EXPECT_LT((sample.angularVelocity - start).norm(), kKept * start.norm());
  }
}

TEST_P(EngineRule, ExplicitGainsHalfOfItsEnergy) {
  const Trajectory motion = thrownBy(Integrator::ExplicitGyroscopic);
  EXPECT_NEAR(energyOf(motion), 1.475, 0.001);  // measured 1.4754
  EXPECT_EQ(motion.samples.back().halfTurns, 3);
}

TEST_P(EngineRule, ImplicitLosesAQuarterOfItsEnergy) {
  const Trajectory motion = thrownBy(Integrator::ImplicitGyroscopic);
  EXPECT_NEAR(energyOf(motion), 0.722, 0.001);    // measured 0.7220
  EXPECT_NEAR(momentumOf(motion), 0.850, 0.001);  // measured 0.8498
}

// Flips come ever more rarely as the energy approaches that of a spin about the middle axis.
TEST_P(EngineRule, RenormalisedCreepsToTheEnergyOfTheMiddleAxis) {
  const Trajectory motion = thrownBy(Integrator::Renormalised);
  const Sample &start = motion.samples.front(), &end = motion.samples.back();
  const double moment = thrown(GetParam(), Integrator::Renormalised).body.solidInertia()[0];
  const double aboutMiddle = start.angularMomentum.squaredNorm() / (2 * moment) / start.kinetic;
  EXPECT_NEAR(energyOf(motion) - 1, 5.2e-5, 1e-6);       // measured 5.19e-5
  EXPECT_NEAR(energyOf(motion) / aboutMiddle, 1, 1e-5);  // measured 7.4e-6, at first 5.9e-5
  EXPECT_NEAR(momentumOf(motion), 1, kKept);
  EXPECT_EQ(end.halfTurns, 3);
}

INSTANTIATE_TEST_SUITE_P(OfEachModel, EngineRule, testing::Values(Model::Matrix, Model::Quaternion),
                         [](const auto& model) { return nameOf(model.param); });

/// The rules as engines compute them: with the angular velocity in the world's axes.
struct InWorld {
  Matrix3d worldFromBody = Matrix3d::Identity();
  Vector3d angularVelocity;  // [rad/s]
  Vector3d inertia;          // [kg m^2]

  Matrix3d tensor() const {
    return worldFromBody * inertia.asDiagonal() * worldFromBody.transpose();
  }
  /// h w x I w. [kg m^2/s]
  Vector3d impulse() const { return kStep * angularVelocity.cross(tensor() * angularVelocity); }
  Vector3d explicitly() const { return angularVelocity - tensor().inverse() * impulse(); }
  Vector3d implicitly() const {
    const Matrix3d jacobian = tensor() + kStep * (rigid::crossMatrix(angularVelocity) * tensor() -
                                                  rigid::crossMatrix(tensor() * angularVelocity));
    return angularVelocity - jacobian.fullPivLu().solve(impulse());
  }
  Vector3d renormalised() const {
    return (tensor() * angularVelocity).norm() / (tensor() * explicitly()).norm() * explicitly();
  }
  void turnWith(const Vector3d& velocity) {
    angularVelocity = velocity;
    worldFromBody =
        Eigen::AngleAxisd(kStep * velocity.norm(), velocity.normalized()) * worldFromBody;
  }
};

void compareWithRuleInWorld(Integrator integrator, Vector3d (InWorld::*rule)() const) {
  MotionSettings settings = thrown(Model::Quaternion, integrator);
  settings.initial = {.value = {1.1, -2.3, -3.7}};
  const auto simulator = makeSimulator(settings);
  InWorld expected{.angularVelocity = settings.initial.value,
                   .inertia = settings.body.solidInertia()};
  for (int step = 0; step < 20; ++step) expected.turnWith((expected.*rule)());
  simulator->advance(20 * kStep, 20);
  const BodyState state = simulator->state();
  EXPECT_LT((state.angularVelocity - expected.angularVelocity).norm(), kStepBound);
  EXPECT_LT((state.worldFromBody - expected.worldFromBody).norm(), kStepBound);
}

TEST(EngineRules, AreThoseOfTheEngines) {
  compareWithRuleInWorld(Integrator::ExplicitGyroscopic, &InWorld::explicitly);
  compareWithRuleInWorld(Integrator::ImplicitGyroscopic, &InWorld::implicitly);
  compareWithRuleInWorld(Integrator::Renormalised, &InWorld::renormalised);
}

}  // namespace
}  // namespace rotatebook::physics
