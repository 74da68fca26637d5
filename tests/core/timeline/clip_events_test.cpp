#include "timeline/clip_events.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/number_text.h"
#include "scene/scene_text.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::timeline {
namespace {

using ::testing::ElementsAre;

/// A motion whose half-turns are given, a sample each tenth of a second.
physics::Trajectory turning(const std::vector<int>& halfTurns) {
  physics::Trajectory trajectory;
  trajectory.interval = 0.1;
  for (std::size_t i = 0; i < halfTurns.size(); ++i) {
    physics::Sample sample;
    sample.time = 0.1 * static_cast<double>(i);
    sample.halfTurns = halfTurns[i];
    trajectory.samples.push_back(sample);
  }
  return trajectory;
}

/// Returns "2 0.2 LABEL: WORDS" of each event.
std::vector<std::string> eventsOf(const scene::Scene& scene,
                                  std::vector<physics::Trajectory> trajectories) {
  std::vector<std::string> words;
  for (const ClipEvent& event :
       eventsOf(scene, ClipMotion(std::move(trajectories), scene.clip.frameRate))) {
    words.push_back(std::to_string(event.frame) + " " + roundedText(event.time, 4) + " " +
                    (event.label.empty() ? "" : event.label + ": ") + event.words);
  }
  return words;
}

TEST(ClipEvents, TellOfEachHalfTurn) {
  EXPECT_THAT(eventsOf({}, {turning({0, 0, 1, 1, 2})}),
              ElementsAre("2 0.2 flip 1", "4 0.4 flip 2"));
  EXPECT_THAT(eventsOf({}, {turning({20, 21, 111})}),
              ElementsAre("1 0.1 flip 21", "2 0.2 flip 111"));
}

TEST(ClipEvents, TellOfAHalfTurnWhenItIsNotWhenAFrameShowsIt) {
  physics::Trajectory motion = turning({0, 0, 1});
  motion.samples[1].tiltDeg = 115;
  motion.samples[2].tiltDeg = 125;
  EXPECT_THAT(eventsOf({}, {motion}), ElementsAre("2 0.15 flip 1"));
}

TEST(ClipEvents, AreNoneWhereNothingTurnsOver) {
  EXPECT_THAT(eventsOf({}, {turning({0, 0, 0})}), ElementsAre());
}

TEST(ClipEvents, TellOfNudgesAndTheEnd) {
  scene::Scene scene;
  scene.motions[0].nudges.push_back({.at = 0.15});
  physics::Trajectory motion = turning({0, 0, 0});
  motion.divergedAt = 0.3;
  EXPECT_THAT(eventsOf(scene, {motion}), ElementsAre("2 0.15 nudge 1", "3 0.3 burst"));
  scene.overlay.words = scene::germanWords();
  EXPECT_THAT(eventsOf(scene, {motion}), ElementsAre("2 0.15 Stoß 1", "3 0.3 auseinandergeflogen"));
}

TEST(ClipEvents, NameTheMotionsOfAComparison) {
  scene::Scene scene;
  scene.motions.resize(2);
  scene.motions[0].label = "one";
  scene.motions[1].label = "two";
  EXPECT_THAT(eventsOf(scene, {turning({0, 0, 1}), turning({0, 1, 1})}),
              ElementsAre("1 0.1 two: flip 1", "2 0.2 one: flip 1"));
}

TEST(ClipEvents, AreOfTheMotionThatTheClipShows) {
  const scene::Scene scene = scene::parseScene(
      "[initial]\nangular_velocity = [4, 0, 0]\ntilt = [0.014, \"z\"]\n[simulation]\nmodel = "
      "\"exact\"\n[clip]\nspeed = 0.5\nfps = 10\nduration = 10\n",
      "scenes/a.toml");
  // At half the speed, 2.45 s of the motion are 4.9 s of the clip.
  const ClipMotion motion = simulateScene(scene);
  EXPECT_THAT(eventsOf(scene, motion.trajectories()), ElementsAre("49 2.423 flip 1"));
}

}  // namespace
}  // namespace rotatebook::timeline
