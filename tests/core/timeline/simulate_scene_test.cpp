#include "timeline/simulate_scene.h"

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
  scene.initial.value = {5, 0.1, 0};
  scene.clip.frameRate = {10, 1};
  scene.clip.duration = 4;
  scene.simulation.timePerFrame = 0.1;
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
      book + "[grid]\ncolumns = { over = 'simulation.substeps', values = [1, 1000] }", "a.toml"));
  const auto& [refused, solved] = std::tie(motion.trajectories()[0], motion.trajectories()[1]);
  EXPECT_EQ(refused.divergedAt, 0.1);
  EXPECT_EQ(refused.samples.size(), 1U);
  EXPECT_FALSE(solved.divergedAt);
  EXPECT_EQ(solved.samples.size(), 10U);
  EXPECT_EQ(motion.frameCount(), 10);
}

}  // namespace
}  // namespace rotatebook::timeline
