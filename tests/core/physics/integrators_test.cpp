// The promises of each integrator's documentation: its order, and what it keeps.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "physics/exact_simulator.h"
#include "physics/integrator_names.h"
#include "physics/integrators/integrator_table.h"
#include "physics/integrators/step_error.h"
#include "physics/scenarios.h"

namespace rotatebook::physics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::Not;

constexpr double kOrderBound = 0.02;        // measured 0.0082 (dmv6, stable spin)
constexpr double kRoundingDrift = 3e-13;    // relative, in 20,000 steps; measured 7.0e-14
constexpr double kRealDrift = 1e-9;         // no rounding; measured 4.6e-9 (suzuki4) and more
constexpr double kOrthogonalBound = 1e-14;  // measured 2.8e-15
constexpr double kUndoneBound = 1e-11;      // without normalisation; measured 4.6e-12
constexpr double kDistorted = 1e-8;         // no rounding; measured 3.1e-7 (rk4) and more
constexpr double kLongStepDrift = 1e-13;    // in ten steps of any length; measured 2.3e-15
constexpr double kBestOrderBound = 2e-7;    // measured 8.6e-8; reversed 1.1e-6
constexpr double kModestStep = 0.2;         // [s]; refused from 0.237 on (dmv2)
constexpr double kManyStepsDrift = 2e-13;   // in 1e6 steps; measured 1.0e-13 (dmv6)
constexpr double kModestDrift = 2e-13;      // relative, in 1000 of them; measured 3.9e-14 (dmv2)
constexpr double kDuration = 1;             // [s]

struct Case {
  Model model;
  Integrator integrator;
};

const IntegratorRow& rowOf(const Case& one) {
  return integratorTable()[static_cast<std::size_t>(one.integrator)];
}

/// Returns whether its row says that it keeps `what`.
bool keeps(const Case& one, const std::string& what) {
  const std::string all(steppingOf(one.model, one.integrator)->keeps);
  return (", " + all.substr(0, all.find(';')) + ", ").find(", " + what + ", ") != std::string::npos;
}

/// A second, in so many steps, is within the asymptotic range.
int coarseStepsOf(const Case& one) {
  const int order = rowOf(one).order;
  return order == 1 ? 16000 : order == 4 ? 150 : order == 6 ? 50 : 1000;
}

/// Every integrator of both rigid models.
std::vector<Case> rigidCases() {
  std::vector<Case> cases;
  for (const Model model : {Model::Quaternion, Model::Matrix}) {
    for (const Integrator integrator : integratorsOf(model)) cases.push_back({model, integrator});
  }
  return cases;
}

void PrintTo(const Case& one, std::ostream* stream) {
  *stream << nameOf(one.model, one.integrator);
}

// Far from every axis: both momentum and attitude wander.
MotionSettings genericSpin(const Case& one) {
  MotionSettings settings = spinning(one.model, {1.1, -2.3, -3.7}, kDuration);
  settings.body = {{0.15, 0.22, 0.04}, 1};
  settings.simulation.integrator = one.integrator;
  return settings;
}

// About the axis of the largest moment of inertia, a little aslant.
MotionSettings stableSpin(const Case& one) {
  MotionSettings settings = genericSpin(one);
  settings.initial.value = {0.3, 0.2, 6.2};
  return settings;
}

// Angle to the exact attitude and distance to the exact angular velocity, in one number.
double errorAfter(const MotionSettings& settings, int steps) {
  const auto simulator = makeSimulator(settings);
  simulator->advance(kDuration, steps);
  const rigid::ExactRotation exact(modelInertia(settings), initialAngularVelocity(settings));
  const rigid::ExactRotation::Moment truth = exact.at(kDuration);
  const BodyState state = simulator->state();
  return ((state.worldFromBody - truth.worldFromBody) * settings.body.corners()).norm() +
         (state.angularVelocity - truth.angularVelocity).norm();
}

double slopeOf(const MotionSettings& settings, int coarseSteps) {
  const double coarse = errorAfter(settings, coarseSteps);
  const double fine = errorAfter(settings, 2 * coarseSteps);
  return std::log2(coarse / fine);
}

struct Drift {
  double energy = 0;    // largest relative change
  double momentum = 0;  // of the vector L, relative
  double size = 0;      // of the size of L, relative
  double shape = 0;     // of the map that is drawn, from a rotation
};

// In 20,000 steps, looked at every 100.
Drift driftOf(const MotionSettings& settings, double h) {
  const auto simulator = makeSimulator(settings);
  const BodyState start = simulator->state();
  Drift drift;
  for (int look = 0; look < 200; ++look) {
    simulator->advance(100 * h, 100);
    const BodyState now = simulator->state();
    const Matrix3d map = now.worldFromBody;
    drift.energy = std::max(drift.energy, std::abs(now.kinetic / start.kinetic - 1));
    drift.momentum = std::max(drift.momentum, (now.angularMomentum - start.angularMomentum).norm() /
                                                  start.angularMomentum.norm());
    drift.size = std::max(drift.size,
                          std::abs(now.angularMomentum.norm() / start.angularMomentum.norm() - 1));
    drift.shape = std::max(drift.shape, (map.transpose() * map - Matrix3d::Identity()).norm());
  }
  return drift;
}

class EachRigidIntegrator : public testing::TestWithParam<Case> {};

TEST_P(EachRigidIntegrator, HasItsOrderOnAGenericSpin) {
  const double slope = slopeOf(genericSpin(GetParam()), coarseStepsOf(GetParam()));
  EXPECT_NEAR(slope, rowOf(GetParam()).order, kOrderBound);
}

TEST_P(EachRigidIntegrator, HasItsOrderOnAStableSpin) {
  const double slope = slopeOf(stableSpin(GetParam()), coarseStepsOf(GetParam()));
  EXPECT_NEAR(slope, rowOf(GetParam()).order, kOrderBound);
}

TEST_P(EachRigidIntegrator, StaysARotation) {
  const Drift drift = driftOf(genericSpin(GetParam()), 0.01);
  EXPECT_LT(drift.shape, kOrthogonalBound);
}

TEST_P(EachRigidIntegrator, NeedsNoNormalisationIfItSaysSo) {
  MotionSettings settings = genericSpin(GetParam());
  settings.simulation.normalizeEvery = 0;
  const double shape = driftOf(settings, 0.01).shape;
  if (keeps(GetParam(), "rotation")) {
    EXPECT_LT(shape, kUndoneBound);
  } else {
    EXPECT_FALSE(shape < kDistorted) << shape;
  }
}

TEST_P(EachRigidIntegrator, KeepsTheAngularMomentumIfItSaysSo) {
  const Drift drift = driftOf(genericSpin(GetParam()), 0.01);
  if (keeps(GetParam(), "L")) {
    EXPECT_LT(drift.momentum, kRoundingDrift);
  } else {
    EXPECT_FALSE(drift.momentum < kRealDrift) << drift.momentum;
  }
  if (keeps(GetParam(), "L") || keeps(GetParam(), "size of L")) {
    EXPECT_LT(drift.size, kRoundingDrift);
  } else {
    EXPECT_FALSE(drift.size < kRealDrift) << drift.size;
  }
}

TEST_P(EachRigidIntegrator, KeepsTheEnergyIfItSaysSo) {
  const double energy = driftOf(genericSpin(GetParam()), 0.02).energy;
  if (keeps(GetParam(), "energy")) {
    EXPECT_LT(energy, kRoundingDrift);
  } else {
    EXPECT_FALSE(energy < kRealDrift) << energy;
  }
}

INSTANTIATE_TEST_SUITE_P(All, EachRigidIntegrator, testing::ValuesIn(rigidCases()),
                         [](const auto& instance) {
                           return nameOf(instance.param.model, instance.param.integrator);
                         });

// Its energy error goes up and down with the motion, and doesn't grow.
TEST(Splitting, KeepsTheEnergyWithoutDrift) {
  const Case splitting{Model::Quaternion, Integrator::Splitting};
  const auto simulator = makeSimulator(genericSpin(splitting));
  const double start = simulator->state().kinetic;
  std::vector<double> largest(10, 0);
  for (double& error : largest) {
    for (int look = 0; look < 200; ++look) {
      simulator->advance(0.1, 10);
      error = std::max(error, std::abs(simulator->state().kinetic / start - 1));
    }
  }
  EXPECT_LT(largest.back(), 1.01 * largest.front());  // measured 1.000
  EXPECT_GT(largest.front(), 1e-6);                   // measured 5.5e-5
}

// Of the six orders of the axes: from the smallest moment to the largest and back.
TEST(Splitting, TurnsAboutTheAxesInTheBestOrder) {
  MotionSettings settings = genericSpin({Model::Quaternion, Integrator::Splitting});
  settings.initial.value = {0, 6.275, 0.314};
  EXPECT_LT(errorAfter(settings, 1000), kBestOrderBound);
}

constexpr Integrator kImplicit[]{Integrator::Midpoint, Integrator::Dmv2, Integrator::Dmv4,
                                 Integrator::Dmv6};

MotionSettings withStep(Integrator integrator, double h) {
  MotionSettings settings = genericSpin({Model::Quaternion, integrator});
  settings.simulation.timePerFrame = h;
  return settings;
}

// However long the step: a solution that keeps the energy, or a word that there is none.
TEST(ImplicitIntegrators, SolveForAStepOrSayThatTheyDoNot) {
  for (const Integrator integrator : kImplicit) {
    int refused = 0;
    for (double h = 0.01; h < 1e6; h *= 1.3) {
      const auto simulator = makeSimulator(withStep(integrator, h));
      const double start = simulator->state().kinetic;
      try {
        simulator->advance(10 * h, 10);
        const double now = simulator->state().kinetic;
        EXPECT_LT(std::abs(now / start - 1), kLongStepDrift) << nameOf(integrator) << " " << h;
      } catch (const StepError& error) {
        ++refused;
        EXPECT_THAT(error.what(), HasSubstr("use shorter steps"));
      }
    }
    EXPECT_GT(refused, 10) << nameOf(integrator);  // measured 55 and more
  }
}

// Nearly a radian in a step is no reason to give up, nor to solve less well.
TEST(ImplicitIntegrators, SolveForStepsOfNearlyARadian) {
  for (const Integrator integrator : kImplicit) {
    const auto simulator = makeSimulator(withStep(integrator, kModestStep));
    const BodyState start = simulator->state();
    EXPECT_NEAR(start.angularVelocity.norm() * kModestStep, 0.9, 0.01);
    simulator->advance(1000 * kModestStep, 1000);
    const BodyState now = simulator->state();
    EXPECT_LT(std::abs(now.kinetic / start.kinetic - 1), kModestDrift) << nameOf(integrator);
    EXPECT_LT((now.angularMomentum - start.angularMomentum).norm(),
              kModestDrift * start.angularMomentum.norm())
        << nameOf(integrator);
    EXPECT_GT((now.worldFromBody - start.worldFromBody).norm(), 0.1)
        << nameOf(integrator) << " stands still";
  }
}

// The sums are compensated, and iterated to the last digit, so that rounding adds up to no drift.
TEST(ImplicitIntegrators, KeepEnergyAndMomentumOverAMillionSteps) {
  for (const Integrator integrator : kImplicit) {
    for (const double h : {0.0066, 0.033}) {
      const auto simulator = makeSimulator(withStep(integrator, h));
      const BodyState start = simulator->state();
      simulator->advance(1e6 * h, 1'000'000);
      const BodyState now = simulator->state();
      const double energy = now.kinetic / start.kinetic - 1;
      const double momentum = now.angularMomentum.norm() / start.angularMomentum.norm() - 1;
      std::cout << nameOf(integrator) << " " << h << ": " << energy << " " << momentum << '\n';
      EXPECT_LT(std::max(std::abs(energy), std::abs(momentum)), kManyStepsDrift)
          << nameOf(integrator) << " " << h;
    }
  }
}

// Fixed-point iteration gives up at a step of about two radians, the solution goes on.
TEST(ImplicitIntegrators, FindTheSolutionBeyondTheReachOfIteration) {
  const double longStep = 2.4 / 4.5;  // [s]
  const auto simulator = makeSimulator(withStep(Integrator::Midpoint, longStep));
  const BodyState start = simulator->state();
  simulator->advance(100 * longStep, 100);
  EXPECT_LT(std::abs(simulator->state().kinetic / start.kinetic - 1), kLongStepDrift);
}

// A spin of w about a principal axis has c = (1 + c^2) h w / 2, which has no root from h w = 1 on.
TEST(ImplicitIntegrators, GiveUpWhereThereIsNoSolution) {
  for (const auto& [rate, isSolved] : {std::pair{0.999, true}, {1.001, false}}) {
    MotionSettings settings = spinning(Model::Quaternion, {0, 0, rate}, 1);
    settings.simulation.integrator = Integrator::Dmv2;
    const auto simulator = makeSimulator(settings);
    if (isSolved) {
      EXPECT_NO_THROW(simulator->advance(1, 1));
    } else {
      EXPECT_THROW(simulator->advance(1, 1), NoConvergence);
    }
  }
}

// Outside the reach of their series dmv4 and dmv6 would have moments of inertia below zero.
TEST(ImplicitIntegrators, RefuseStepsOutsideTheReachOfTheirSeries) {
  for (const Integrator integrator : {Integrator::Dmv4, Integrator::Dmv6}) {
    for (const double h : {0.48, 0.56, 0.64}) {
      MotionSettings settings = spinning(Model::Quaternion, {3, 0.4, 4}, h);
      settings.inertia = Vector3d(0.31, 0.52, 0.67).asDiagonal();
      settings.simulation.integrator = integrator;
      const auto simulator = makeSimulator(settings);
      try {
        simulator->advance(h, 1);
        ADD_FAILURE() << nameOf(integrator) << " " << h;
      } catch (const StepTooLong& error) {
        EXPECT_THAT(error.what(), HasSubstr(" is too long for dmv"));
        EXPECT_THAT(error.what(), HasSubstr("where 1/2 to 2 is its reach; use shorter steps"));
      }
    }
  }
}

TEST(ImplicitIntegrators, RoundTheNumbersOfMessages) {
  for (const auto& [integrator, words] :
       {std::pair{Integrator::Dmv4,
                  "a step of 0.28 s is too long for dmv4: its series changes a "
                  "moment of inertia by the factor "},
        {Integrator::Dmv2, "finds no solution for a step of 0.28 s: "}}) {
    MotionSettings settings = spinning(Model::Quaternion, {0, 0, 30}, 1);
    settings.simulation.integrator = integrator;
    try {
      makeSimulator(settings)->advance(0.27999999999999997, 1);
      ADD_FAILURE() << nameOf(integrator);
    } catch (const StepError& error) {
      EXPECT_THAT(error.what(), HasSubstr(words));
      EXPECT_THAT(error.what(), Not(MatchesRegex(".*[0-9][0-9][0-9][0-9][0-9][0-9].*")));
    }
  }
}

// One step, whose numbers may overflow on the way: what isn't finite is no solution.
TEST(ImplicitIntegrators, EndNoStepInNumbersThatAreNotFinite) {
  for (const Integrator integrator : kImplicit) {
    for (double h = 0.01; h < 1e300; h *= 1.3) {
      const auto simulator = makeSimulator(withStep(integrator, h));
      try {
        simulator->advance(h, 1);
      } catch (const StepError&) {
        continue;
      }
      EXPECT_TRUE(simulator->state().worldFromBody.allFinite()) << nameOf(integrator) << " " << h;
      EXPECT_TRUE(std::isfinite(simulator->state().kinetic)) << nameOf(integrator) << " " << h;
    }
  }
}

}  // namespace
}  // namespace rotatebook::physics
