#include "timeline/notes.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/scene_text.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::timeline {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

scene::Scene sceneWith(const std::string& settings) {
  return scene::parseScene("title = \"t\"\n" + settings, "s.toml");
}

std::vector<std::string> notesWith(const std::string& settings) {
  return notesOn(sceneWith(settings));
}

TEST(Notes, TellOfCuesThatAreNeverShown) {
  EXPECT_THAT(notesOn(scene::parseScene(
                  "clip.duration = 2\n[initial]\nangular_velocity = [5, 1, 0]\n[[cue]]\nat = 1\n"
                  "text = 'a'\n[[cue]]\nat = 3\ntext = 'b'\n",
                  "a.toml")),
              ElementsAre("cue.1 is at 3 s of the motion, after the end of the clip, which never "
                          "shows it"));
}

TEST(Notes, AreNoneOnAnOrdinaryScene) {
  EXPECT_THAT(notesWith("initial.angular_velocity = [5, 0, 0]\ninitial.tilt = [0.5, \"z\"]\n"),
              IsEmpty());
  EXPECT_THAT(notesWith("initial.angular_velocity = [0, 1, 5]\n"), IsEmpty());
  // A body with two equal moments tumbles about no axis, and particles do by their rounding.
  EXPECT_THAT(notesWith("initial.angular_velocity = [0, 0, 5]\nbody.size = [0.2, 0.2, 0.1]\n"),
              IsEmpty());
  EXPECT_THAT(notesWith("initial.angular_velocity = [0, 0, 5]\n"
                        "body.inertia = [[1, 0.2, 0], [0.2, 1, 0], [0, 0, 1.2]]\n"),
              IsEmpty());
  EXPECT_THAT(notesWith("initial.angular_velocity = [5, 0, 0]\nsimulation.model = \"particles\"\n"),
              IsEmpty());
}

TEST(Notes, AreMadeOnAPosterAfterTheEnd) {
  const std::string clip =
      "initial.angular_velocity = [0, 1, 5]\nclip.duration = 2\nclip.poster = ";
  EXPECT_THAT(notesWith(clip + "2"), IsEmpty());
  EXPECT_THAT(notesWith(clip + "99"),
              ElementsAre("clip.poster is at 99 s, after the end of the clip, which lasts 2 s; its "
                          "last frame is the poster"));
}

TEST(Notes, AreMadeOnATiltInDegrees) {
  EXPECT_THAT(
      notesWith("initial.angular_velocity = [5, 0, 0]\ninitial.tilt = [1, \"z\"]\n"),
      ElementsAre("initial.tilt is 57.3 degrees; numbers without a unit are in radians: one "
                  "degree is \"1 deg\""));
}

TEST(Notes, AreMadeOnABodyInCentimetres) {
  EXPECT_THAT(
      notesWith("initial.angular_velocity = [0, 1, 5]\nbody.size = [18.78, 29.085, 5]\n"),
      ElementsAre(StartsWith("the body is 29.1 m long; numbers without a unit are in metres")));
}

TEST(Notes, AreMadeOnASpinTooFastForTheFrames) {
  EXPECT_THAT(notesWith("initial.angular_velocity = [500, 0, 0.1]\n"),
              ElementsAre(HasSubstr("spins by 1.33 turns from frame to frame")));
  EXPECT_THAT(notesWith("initial.angular_velocity = [150, 0, 90]\n"),
              ElementsAre(HasSubstr("frames, so that frames, counts and expectations miss some")));
}

TEST(Notes, AreNoneOnTheFlipsOfABodyThatHasNone) {
  const std::string rod = "body.inertia = [5, 5, 0.04]\ninitial.angular_velocity = ";
  EXPECT_THAT(notesWith(rod + "[0, 1, 100]\n"), IsEmpty());
  EXPECT_THAT(notesWith("initial.angular_velocity = [0, 20, 120]\n"), IsEmpty());
}

TEST(Notes, AreMadeOnASpinThatNeverTumbles) {
  EXPECT_THAT(notesWith("initial.angular_velocity = [5, 0, 0]\n"),
              ElementsAre(HasSubstr("exactly about the middle axis")));
}

TEST(Notes, AreMadeOnASpinThatOnlyTurns) {
  const auto note = [](const std::string& moment) {
    return "the spin is exactly about the axis of the " + moment +
           " moment of inertia, so the body turns steadily and shows nothing else; add "
           "initial.tilt, for example [\"1 deg\", \"x\"], to see that it only wobbles";
  };
  EXPECT_THAT(notesWith("initial.angular_velocity = [0, 5, 0]\n"), ElementsAre(note("smallest")));
  EXPECT_THAT(notesWith("initial.angular_velocity = [0, 0, 5]\n"), ElementsAre(note("largest")));
  EXPECT_THAT(notesWith("initial.angular_velocity = [0, 0, 5]\ninitial.tilt = [0.0175, \"x\"]\n"),
              IsEmpty());
}

// A tilt toward the axis of the spin would be none.
TEST(Notes, TiltTowardAnAxisAcrossTheSpin) {
  EXPECT_THAT(notesWith("initial.angular_velocity = [5, 0, 0]\nbody.size = [0.3, 0.2, 0.1]\n"),
              ElementsAre(HasSubstr("initial.tilt, for example [\"1 deg\", \"z\"]")));
  EXPECT_THAT(notesWith("initial.angular_velocity = [0, 0, 5]\nbody.size = [0.3, 0.1, 0.2]\n"),
              ElementsAre(HasSubstr("initial.tilt, for example [0.001, \"x\"]")));
}

TEST(Notes, BeginWithThePanelsLabel) {
  EXPECT_THAT(notesWith("initial.angular_velocity = [5, 0, 0]\n[[panel]]\nlabel = \"A\"\n"
                        "initial.tilt = [2, \"z\"]\n[[panel]]\nlabel = \"B\"\n"
                        "initial.angular_velocity = [0, 0, 5]\n"),
              ElementsAre(StartsWith("A: initial.tilt is 115 degrees")));
}

TEST(Notes, AreMadeOnARegimeThatChanges) {
  const auto noteWith = [](const std::string& settings) {
    const scene::Scene scene = sceneWith(
        "initial.angular_velocity = [5, 0, 0]\ninitial.tilt = [0.01, \"z\"]\n" + settings);
    return regimeNote(simulateScene(scene).trajectories().front(), scene.motions[0].nudges);
  };
  EXPECT_THAT(noteWith("simulation.integrator = \"euler\"\n"),
              StartsWith("the regime changes from 1 to -1 at "));
  EXPECT_EQ(noteWith(""), "");
}

TEST(Notes, TakeARegimeThatANudgeChangesForWhatItIs) {
  const scene::Scene scene = sceneWith(
      "initial.angular_velocity = [5, 0, 0]\ninitial.tilt = [0.001, \"y\"]\n"
      "[[nudge]]\nat = 1\nangular_velocity = [0, 0, 0.5]\n");
  const physics::Trajectory trajectory = simulateScene(scene).trajectories().front();
  EXPECT_NE(trajectory.samples.front().regime, trajectory.samples.back().regime);
  EXPECT_EQ(regimeNote(trajectory, scene.motions[0].nudges), "");
  EXPECT_NE(regimeNote(trajectory, {}), "");
}

TEST(Notes, AreMadeOnANudgeAfterTheEnd) {
  EXPECT_THAT(notesWith("initial.angular_velocity = [5, 0, 0]\n"
                        "[[nudge]]\nat = 30\nangular_velocity = [0, 0, 1]\n"),
              ElementsAre(StartsWith("the nudge at 30 s comes after the end")));
}

TEST(Notes, AreMadeOnAMoveThatOutlastsTheClip) {
  const std::string move =
      "clip.duration = 6\ninitial.angular_velocity = [0, 1, 5]\n[[cue]]\nat = 2\n"
      "move = { orbit = '90 deg', over = ";
  EXPECT_THAT(notesWith(move + "4 }\n"), IsEmpty());
  EXPECT_THAT(notesWith(move + "20 }\n"),
              ElementsAre("cue.0.move takes 20 s, and the clip ends before, after 4 s of it"));
}

}  // namespace
}  // namespace rotatebook::timeline
