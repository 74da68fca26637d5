#include "physics/exact_simulator.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "physics/scenarios.h"

namespace rotatebook::physics {
namespace {

using Eigen::Vector3d;

constexpr double kExactBound = 1e-14;      // measured 5e-16
constexpr double kErrorBoundDeg = 1e-12;   // measured 5.4e-14
constexpr double kSteadyBoundDeg = 1e-12;  // measured 5e-14

MotionSettings tumbling(int substeps) {
  MotionSettings settings = spinning(Model::Exact, {4, 0, 0}, 1.0 / 60);
  settings.initial.tilt = Tilt{0.01, 2};
  settings.simulation.substeps = substeps;
  return settings;
}

TEST(ExactSimulator, DoesNotDependOnTheSteps) {
  const Trajectory coarse = simulate(tumbling(1), 1200);
  const Trajectory fine = simulate(tumbling(64), 1200);
  const body::Cage difference = coarse.samples.back().cage - fine.samples.back().cage;
  EXPECT_LT(difference.norm(), kExactBound);
}

// An angular velocity and frames so long that a time that is off by rounding alone would show.
TEST(ExactSimulator, IsEvaluatedAtWholeFramesWhateverTheSubsteps) {
  MotionSettings settings = spinning(Model::Exact, {1.1, -2.3, -3.7}, 100.1);
  const body::Cage expected = simulate(settings, 100).samples.back().cage;
  for (const int substeps : {3, 7, 60}) {
    settings.simulation.substeps = substeps;
    EXPECT_EQ(simulate(settings, 100).samples.back().cage, expected) << substeps;
  }
}

TEST(ExactSimulator, CountsTheTimeOfIntervalsOfDifferentLength) {
  ExactSimulator one(tumbling(1)), two(tumbling(1));
  one.advance(0.5, 8);
  one.advance(0.5, 8);
  one.advance(1, 2);
  two.advance(2, 1);
  EXPECT_EQ(one.state().worldFromBody, two.state().worldFromBody);
}

TEST(ExactSimulator, IsItsOwnYardstickAndKeepsEverything) {
  const Trajectory trajectory = simulate(tumbling(1), 1200);
  const Sample& start = trajectory.samples.front();
  for (const Sample& sample : trajectory.samples) {
    EXPECT_LT(sample.errorDeg, kErrorBoundDeg);
    EXPECT_NEAR(sample.total() / start.total(), 1, 100 * kExactBound);
    EXPECT_EQ(sample.angularMomentum, start.angularMomentum);
    EXPECT_EQ(sample.regime, rigid::Regime::AboutLargest);
  }
  EXPECT_GT(trajectory.samples.back().halfTurns, 3);
}

// However near to the separatrix it starts.
TEST(ExactSimulator, StaysInTheRegimeOfItsStart) {
  for (const double tilt : {1e-7, 1e-9, 1e-12, 1e-300}) {
    for (const auto& [axis, regime] :
         {std::pair{2, rigid::Regime::AboutLargest}, {1, rigid::Regime::AboutSmallest}}) {
      MotionSettings settings = tumbling(1);
      settings.initial.tilt = Tilt{tilt, axis};
      for (const Sample& sample : simulate(settings, 1200).samples) {
        EXPECT_EQ(sample.regime, regime) << tilt << " " << axis << " " << sample.time;
      }
    }
  }
}

TEST(ExactSimulator, StartsWithTheBookAsItIs) {
  const MotionSettings settings = tumbling(1);
  const BodyState state = ExactSimulator(settings).state();
  EXPECT_LT((state.worldFromBody - Eigen::Matrix3d::Identity()).norm(), kExactBound);
  EXPECT_LT((state.angularVelocity - initialAngularVelocity(settings)).norm(), kExactBound);
}

// The tensor times (1, 2, 2) is 4.5 (1, 2, 2), the middle moment: the least rounding of an axis
// would turn the body over within half a minute.
MotionSettings aboutTheMiddleAxis() {
  Eigen::Matrix3d tensor;
  tensor << 4, -1, 1.25, -1, 4.75, 0.25, 1.25, 0.25, 3.625;
  MotionSettings settings;
  settings.simulation.model = Model::Exact;
  settings.simulation.timePerFrame = 1;
  settings.inertia = tensor;
  settings.initial.value = {1, 2, 2};
  return settings;
}

double tiltChange(const MotionSettings& settings) {
  const Trajectory trajectory = simulate(settings, 1001);
  double change = 0;
  for (const Sample& sample : trajectory.samples) {
    change = std::max(change, std::fabs(sample.tiltDeg - trajectory.samples.front().tiltDeg));
  }
  return change;
}

TEST(ExactSimulator, SpinsAboutTheMiddleAxisForEver) {
  MotionSettings settings = aboutTheMiddleAxis();
  EXPECT_LT(tiltChange(settings), kSteadyBoundDeg);
  EXPECT_EQ(simulate(settings, 1).samples[0].regime, rigid::Regime::Separatrix);
  settings.initial.kind = InitialSpin::Kind::AngularMomentum;
  EXPECT_LT(tiltChange(settings), kSteadyBoundDeg);
  // Beside the axis it turns over.
  settings.initial.value.x() = std::nextafter(1, 2);
  EXPECT_GT(tiltChange(settings), 90);
}

}  // namespace
}  // namespace rotatebook::physics
