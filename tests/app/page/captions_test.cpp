#include "page/captions.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/scene_text.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::page {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// A motion whose half-turns are given, a sample each tenth of a second.
Motion motionOf(const std::vector<int>& halfTurns, const std::string& label = "") {
  Motion motion;
  motion.panel.label = label;
  motion.trajectory.interval = 0.1;
  for (std::size_t i = 0; i < halfTurns.size(); ++i) {
    physics::Sample sample;
    sample.time = 0.1 * static_cast<double>(i);
    sample.halfTurns = halfTurns[i];
    motion.trajectory.samples.push_back(sample);
  }
  return motion;
}

std::vector<std::string> wordsOf(const std::vector<Event>& events) {
  std::vector<std::string> words;
  for (const Event& event : events)
    words.push_back(std::to_string(event.frame) + " " + event.words);
  return words;
}

TEST(Captions, TellOfEachHalfTurn) {
  EXPECT_THAT(
      wordsOf(eventsOf({motionOf({0, 0, 1, 1, 2})}, 5)),
      ElementsAre("2 0.20 s: turned over, first time", "4 0.40 s: turned over, second time"));
  EXPECT_THAT(wordsOf(eventsOf({motionOf({20, 21, 111})}, 3)),
              ElementsAre("1 0.10 s: turned over, 21st time", "2 0.20 s: turned over, 111th time"));
}

TEST(Captions, TellWhenNothingTurnsOver) {
  EXPECT_THAT(wordsOf(eventsOf({motionOf({0, 0, 0})}, 3)),
              ElementsAre("2 0.20 s: hasn’t turned over"));
}

TEST(Captions, TellOfNudgesAndTheEnd) {
  Motion motion = motionOf({0, 0, 0});
  motion.panel.nudges.push_back({.at = 0.15});
  motion.trajectory.divergedAt = 0.3;
  EXPECT_THAT(wordsOf(eventsOf({motion}, 8)),
              ElementsAre("2 0.15 s: nudged", "3 0.30 s: flew apart"));
}

TEST(Captions, NameTheMotionsOfAComparison) {
  EXPECT_THAT(wordsOf(eventsOf({motionOf({0, 0, 1}, "one"), motionOf({0, 1, 1}, "two")}, 3)),
              ElementsAre("1 0.10 s: two: turned over, first time",
                          "2 0.20 s: one: turned over, first time"));
}

TEST(Captions, AreOfTheMotionThatTheClipShows) {
  const scene::Scene scene = scene::parseScene(
      "[initial]\nangular_velocity = [4, 0, 0]\ntilt = [0.014, \"z\"]\n[simulation]\nmodel = "
      "\"exact\"\n[clip]\nspeed = 0.5\nfps = 10\nduration = 10\n",
      "scenes/a.toml");
  const timeline::ClipMotion motion = timeline::simulateScene(scene);
  const auto events =
      eventsOf({{scene::motionsOf(scene).front(), motion.trajectories().front()}}, 100);
  ASSERT_EQ(events.size(), 1U);
  // At half the speed, 2.45 s of the motion are 4.9 s of the clip.
  EXPECT_EQ(events[0].words, "2.45 s: turned over, first time");
  EXPECT_EQ(events[0].frame, 49);
}

TEST(WebVtt, LastsUntilTheNextEventOrTheEnd) {
  EXPECT_EQ(webVtt({{10, "a"}, {20, "b"}, {70, "c"}}, {10, 1}, 80),
            "WEBVTT\n\n00:00:01.000 --> 00:00:01.950 line:0\na\n\n00:00:02.000 --> 00:00:05.000 "
            "line:0\nb\n"
            "\n00:00:07.000 --> 00:00:07.950 line:0\nc\n");
}

TEST(WebVtt, ShowsTheLastFrameForAWhile) {
  EXPECT_THAT(webVtt({{79, "end"}}, {10, 1}, 80),
              HasSubstr("00:00:07.200 --> 00:00:08.000 line:0\nend\n"));
}

TEST(WebVtt, HoldsWordsAsWords) {
  EXPECT_THAT(webVtt({{0, "a --> <b> & c"}}, {10, 1}, 80),
              AllOf(HasSubstr("a --&gt; &lt;b&gt; &amp; c"), Not(HasSubstr("<b>"))));
  EXPECT_EQ(webVtt({}, {10, 1}, 80), "WEBVTT\n");
}

}  // namespace
}  // namespace rotatebook::page
