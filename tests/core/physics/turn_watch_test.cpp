// TurnWatch sees what simulate() measures.
#include "physics/turn_watch.h"

#include <vector>

#include <gtest/gtest.h>

#include "physics/simulate.h"

namespace rotatebook::physics {
namespace {

MotionSettings flipping(Model model, Integrator integrator, double tilt) {
  MotionSettings settings;
  settings.simulation.model = model;
  settings.simulation.integrator = integrator;
  settings.simulation.timePerFrame = 0.02;
  settings.simulation.substeps = 1;
  settings.initial.value = {5, 0, 0};
  settings.initial.tilt = Tilt{tilt, 2};
  return settings;
}

void expectTheSame(const MotionSettings& settings, int samples) {
  const Trajectory trajectory = simulate(settings, samples);
  TurnWatch watch(settings);
  for (const Sample& sample : trajectory.samples) {
    if (sample.time > 0) {
      ASSERT_TRUE(watch.look(sample.time)) << sample.time;
    }
    ASSERT_EQ(watch.halfTurns(), sample.halfTurns) << sample.time;
  }
  if (trajectory.divergedAt) {
    EXPECT_FALSE(watch.look(*trajectory.divergedAt));
    EXPECT_FALSE(watch.look(*trajectory.divergedAt + 1)) << "for good";
  }
  EXPECT_EQ(watch.divergedAt(), trajectory.divergedAt);
}

TEST(TurnWatch, CountsTheHalfTurnsOfEveryModel) {
  int halfTurns = 0;
  for (const double tilt : {0.3, 1e-3, 1e-7}) {
    for (const Integrator integrator : {Integrator::Euler, Integrator::Rk4}) {
      expectTheSame(flipping(Model::Quaternion, integrator, tilt), 600);
      expectTheSame(flipping(Model::Matrix, integrator, tilt), 600);
    }
    expectTheSame(flipping(Model::Exact, Integrator::Rk4, tilt), 600);
    halfTurns +=
        simulate(flipping(Model::Exact, Integrator::Rk4, tilt), 600).samples.back().halfTurns;
  }
  EXPECT_GT(halfTurns, 5);  // measured 9
}

TEST(TurnWatch, SeesBodiesDeformAndDiverge) {
  MotionSettings settings = flipping(Model::Particles, Integrator::Euler, 1e-3);
  settings.simulation.normalizeEvery = 0;
  settings.simulation.damping = 0;
  ASSERT_TRUE(simulate(settings, 200).divergedAt);
  expectTheSame(settings, 200);
  MotionSettings growing = flipping(Model::Quaternion, Integrator::Euler, 1e-3);
  growing.simulation.normalizeEvery = 0;
  expectTheSame(growing, 600);
}

TEST(TurnWatch, LooksBetweenSteps) {
  const MotionSettings settings = flipping(Model::Quaternion, Integrator::Euler, 0.01);
  const std::vector<double> times{0, 0.013, 1.999, 5.5, 11.111};
  const Trajectory trajectory = simulate(settings, times);
  TurnWatch watch(settings);
  for (std::size_t i = 1; i < times.size(); ++i) {
    ASSERT_TRUE(watch.look(times[i]));
    EXPECT_EQ(watch.halfTurns(), trajectory.samples[i].halfTurns);
  }
}

}  // namespace
}  // namespace rotatebook::physics
