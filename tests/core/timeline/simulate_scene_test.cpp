#include "timeline/simulate_scene.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/scene_text.h"
#include "timeline/shutter_moments.h"

namespace rotatebook::timeline {
namespace {

/// A book in real time, but for a second at half its speed.
scene::Scene slowedScene() {
  scene::Scene scene;
  scene.motions[0].initial.value = {5, 0.1, 0};
  scene.clip.frameRate = {10, 1};
  scene.clip.duration = 4;
  scene.motions[0].simulation.timePerFrame = 0.1;
  scene.clip.speed = scene::PlaybackSpeed{.stretches = {{1, 2, 0.5}}};
  return scene;
}

TEST(FrameTimes, AreThoseOfTheFramesAndTheirParts) {
  const scene::Scene scene = slowedScene();
  const std::vector<double> frames = frameTimes(scene), parts = frameTimes(scene, 4);
  ASSERT_EQ(frames.size(), 40U);
  ASSERT_EQ(parts.size(), 160U);
  for (std::size_t n = 0; n < frames.size(); ++n) EXPECT_EQ(parts[4 * n], frames[n]);
  EXPECT_DOUBLE_EQ(frames[15], 1.25);
  EXPECT_DOUBLE_EQ(parts[4 * 15 + 2], 1.275);
  EXPECT_DOUBLE_EQ(frames[30], 2.5);
}

TEST(SimulateScene, ShowsTheMotionAtTheTimesOfTheFrames) {
  const scene::Scene scene = slowedScene();
  scene::Scene even = scene;
  even.clip.speed.reset();
  const ClipMotion slowed = simulateScene(scene), steady = simulateScene(even);
  const auto& samples = slowed.trajectories()[0].samples;
  const auto& evenSamples = steady.trajectories()[0].samples;
  for (std::size_t n = 0; n < 40; ++n) EXPECT_EQ(samples[n].time, timeAt(scene, double(n)));
  EXPECT_EQ(samples[7].cage, evenSamples[7].cage);
  EXPECT_EQ(samples[30].cage, evenSamples[25].cage);
}

/// The sample of a motion by explicit Euler, in long steps, one second in.
physics::Sample afterASecond(const std::vector<std::string>& overrides) {
  const scene::Scene scene = scene::parseScene(
      "[simulation]\nintegrator = 'euler'\nsubsteps = 4\n"
      "[initial]\nangular_velocity = [5, 0.1, 0]\n[clip]\nduration = 9\n",
      "a.toml", overrides);
  const ClipMotion motion = simulateScene(scene);
  constexpr double kRounding = 1e-12;
  for (const physics::Sample& sample : motion.trajectories()[0].samples) {
    if (std::fabs(sample.time - 1) < kRounding) return sample;
  }
  throw std::logic_error("no sample after a second");
}

TEST(SimulateScene, HasOneMotionWhateverTheRateTheSpeedAndTheSize) {
  const physics::Sample real = afterASecond({});
  const std::vector<std::vector<std::string>> others{
      {"clip.fps=30"},
      {"clip.fps=25"},
      {"clip.fps=50", "clip.speed=2.0"},
      {"clip.speed=0.25"},
      {"clip.speed=0.125"},
      {"clip.speed=[{ from = 0, to = 8, value = 0.25 }]"},
      {"clip.speed=[{ from = 0.5, to = 2, value = 0 }]"},
      {"clip.size=[64, 36]"},
      {"look.motion_blur=16"},
      {"simulation.step='0.004166666666666667 s'"},
      {"simulation.step='0.004166666666666667 s'", "clip.fps=24", "clip.speed=0.5"},
      {"simulation.time_per_frame=0.5", "simulation.step='0.004166666666666667 s'"}};
  for (const std::vector<std::string>& overrides : others) {
    EXPECT_EQ(afterASecond(overrides).cage, real.cage) << overrides.back();
  }
  EXPECT_NE(afterASecond({"simulation.substeps=5"}).cage, real.cage);
  EXPECT_NE(afterASecond({"simulation.step='4 ms'"}).cage, real.cage);
}

TEST(SimulateScene, HoldsThePictureAtASpeedOfZero) {
  scene::Scene scene = slowedScene();
  scene.clip.speed = scene::PlaybackSpeed{.stretches = {{1, 3, 0}}};
  const ClipMotion motion = simulateScene(scene);
  const auto& samples = motion.trajectories()[0].samples;
  for (std::size_t n = 13; n <= 27; ++n) {
    EXPECT_EQ(samples[n].time, samples[13].time);
    EXPECT_EQ(samples[n].cage, samples[13].cage);
  }
  EXPECT_NE(samples[29].cage, samples[27].cage);
}

TEST(ShutterMoments, AreOfTheSameMotionWhateverTheSteps) {
  for (const int substeps : {1, 3, 16, 20}) {
    scene::Scene scene = slowedScene();
    scene.motions[0].simulation.substeps = substeps;
    const ClipMotion sharp = simulateScene(scene);
    scene.look.motionBlur = 4;
    const ShutterMoments moments(scene);
    for (const std::size_t n : {0U, 7U, 15U, 39U}) {
      EXPECT_EQ(moments.at(0, n, 0).cage, sharp.trajectories()[0].samples[n].cage) << substeps;
    }
  }
}

TEST(ShutterMoments, AreCloserInSlowMotion) {
  scene::Scene scene = slowedScene();
  scene.look.motionBlur = 2;
  const ShutterMoments moments(scene);
  constexpr double kRounding = 1e-14;  // [s]; measured 1.8e-16
  EXPECT_NEAR(moments.at(0, 5, 1).time - moments.at(0, 5, 0).time, 0.025, kRounding);
  EXPECT_NEAR(moments.at(0, 15, 1).time - moments.at(0, 15, 0).time, 0.0125, kRounding);
}

/// The steps of the first motion are so long that their equation has no solution.
constexpr const char* kUnsolvable =
    "[initial]\nangular_velocity = [60, 1, 0]\n[simulation]\nintegrator = 'dmv2'\n"
    "[clip]\nfps = 10\nduration = 1\n";

TEST(SimulateScene, EndsInAGridTheMotionWhoseStepCannotBeMade) {
  const std::string book = kUnsolvable;
  EXPECT_THROW(simulateScene(scene::parseScene(book, "a.toml",
                                               std::vector<std::string>{"simulation.substeps=1"})),
               InputError);
  const ClipMotion motion = simulateScene(scene::parseScene(
      book + "[grid]\ncolumns = { key = 'simulation.substeps', values = [1, 1000] }", "a.toml"));
  const auto& [refused, solved] = std::tie(motion.trajectories()[0], motion.trajectories()[1]);
  EXPECT_EQ(refused.divergedAt, 0.1);
  EXPECT_EQ(refused.samples.size(), 1U);
  EXPECT_FALSE(solved.divergedAt);
  EXPECT_EQ(solved.samples.size(), 10U);
  EXPECT_EQ(motion.frameCount(), 10);
}

}  // namespace
}  // namespace rotatebook::timeline
