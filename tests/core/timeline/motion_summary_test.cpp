#include "timeline/motion_summary.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/scene_text.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::timeline {
namespace {

using ::testing::ElementsAre;
using ::testing::StartsWith;

/// A motion with these errors and energies, a sample a second. [degrees, J]
physics::Trajectory trajectoryOf(const std::vector<double>& errors,
                                 const std::vector<double>& energies) {
  physics::Trajectory trajectory;
  trajectory.interval = 1;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    physics::Sample sample;
    sample.time = static_cast<double>(i);
    sample.errorDeg = errors[i];
    sample.kinetic = energies[i];
    sample.halfTurns = static_cast<int>(i);
    trajectory.samples.push_back(sample);
  }
  return trajectory;
}

TEST(MotionSummary, HoldsTheExtremes) {
  const MotionSummary summary = summarize({}, trajectoryOf({0, 11, 170, 4}, {2, 1.5, 1, 3}));
  EXPECT_EQ(summary.frames, 4u);
  EXPECT_THAT(summary.flips, ElementsAre(1, 2, 3));
  EXPECT_EQ(summary.lowestEnergy, 0.5);
  EXPECT_EQ(summary.highestEnergy, 1.5);
  EXPECT_EQ(summary.errorDeg, 170);
  EXPECT_EQ(summary.visibleFrom, 1);
  EXPECT_FALSE(summary.divergedAt);
  EXPECT_TRUE(summary.met());
}

TEST(MotionSummary, HasTheTimesOfFlipsBetweenSamples) {
  physics::Trajectory motion = trajectoryOf({0, 0, 0, 0}, {1, 1, 1, 1});
  const std::vector<double> tilts{50, 110, 130, 50};
  const std::vector<int> counts{0, 0, 1, 2};
  for (std::size_t i = 0; i < 4; ++i) {
    motion.samples[i].tiltDeg = tilts[i];
    motion.samples[i].halfTurns = counts[i];
  }
  EXPECT_THAT(flipsOf(motion), ElementsAre(1.5, 2.875));
}

TEST(MotionSummary, CallsNoErrorVisibleUpToTenDegrees) {
  EXPECT_FALSE(summarize({}, trajectoryOf({0, 10}, {1, 1})).visibleFrom);
}

TEST(MotionSummary, OfTheExactModelHasNoError) {
  scene::Panel exact;
  exact.simulation.model = physics::Model::Exact;
  EXPECT_FALSE(summarize(exact, trajectoryOf({0, 5e-14}, {1, 1})).errorDeg);
}

TEST(MotionSummary, IsUnmetByADivergenceThatNobodyExpects) {
  physics::Trajectory trajectory = trajectoryOf({0, 0}, {1, 1});
  trajectory.divergedAt = 2;
  EXPECT_TRUE(summarize({}, trajectory).met());
  scene::Panel motion;
  motion.expectations = {{.measure = scene::Measure::HalfTurns, .risesTo = 1}};
  const MotionSummary summary = summarize(motion, trajectory);
  ASSERT_EQ(summary.expectations.size(), 1u);
  EXPECT_TRUE(summary.expectations.front().met);
  EXPECT_TRUE(summary.divergesUnexpectedly);
  EXPECT_FALSE(summary.met());
}

TEST(MotionSummary, HasNoNoteOnTheRegimeOfABodyThatLosesEnergy) {
  const scene::Scene scene = scene::parseScene(
      "title = \"t\"\nclip.duration = 2\nsimulation.dissipation = 1e-4\n"
      "initial.angular_velocity = [5, 0, 0]\ninitial.tilt = [0.01, \"y\"]",
      "s.toml");
  const ClipMotion motion = simulateScene(scene);
  EXPECT_NE(regimeNote(motion.trajectories().front(), {}), "");
  EXPECT_THAT(summarize(scene, motion).front().notes, ::testing::IsEmpty());
}

TEST(MotionSummary, IsOfEachPanelInItsOrder) {
  const scene::Scene scene = scene::parseScene(
      "title = \"t\"\nclip.duration = 2\ninitial.angular_velocity = [5, 0, 0]\n"
      "initial.tilt = [0.01, \"z\"]\n"
      "[[panel]]\nlabel = \"A\"\nexpect.half_turns = { min = 5 }\n"
      "[[panel]]\nlabel = \"B\"\nsimulation.integrator = \"euler\"\n",
      "s.toml");
  const std::vector<MotionSummary> both = summarize(scene, simulateScene(scene));
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[0].motion.label, "A");
  EXPECT_EQ(both[1].motion.label, "B");
  EXPECT_THAT(both[1].notes, ElementsAre(StartsWith("the regime changes from 1 to -1 at ")));
  EXPECT_FALSE(both[0].met());
  EXPECT_TRUE(both[1].met());
  EXPECT_FALSE(allMet(both));
}

}  // namespace
}  // namespace rotatebook::timeline
