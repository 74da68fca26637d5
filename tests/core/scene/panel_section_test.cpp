#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "messages.h"
#include "scene/parse.h"
#include "scene/scene_text.h"

namespace rotatebook::scene {
namespace {

using physics::InitialSpin;
using physics::Integrator;
using physics::Model;
using ::testing::HasSubstr;
using ::testing::Not;

// Two panels, the second on `lines` more.
std::string twoPanels(const std::string& lines) {
  return "[initial]\nangular_velocity = [0, 0, 6]\n[[panel]]\nlabel = 'one'\n[[panel]]\n"
         "label = 'two'\n" +
         lines;
}

Scene sceneOf(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return parseScene(text, "a.toml", overrides);
}

TEST(Panels, AreNoneInMostScenes) {
  EXPECT_FALSE(sceneFrom("").hasPanels());
}

TEST(Panels, HaveWhatTheSceneHas) {
  const Scene scene = sceneOf(
      "[body]\nmass = 3\n[simulation]\nmodel = 'matrix'\ntime_per_frame = 0.5\n"
      "[initial]\nangular_velocity = [0, 0, 6]\ntilt = [0.1, 'x']\n[expect]\nstretch.max = 2\n"
      "[[panel]]\nlabel = 'one'\n[[panel]]\nlabel = 'two'\n");
  ASSERT_EQ(scene.motions.size(), 2U);
  EXPECT_EQ(scene.motions[0].label, "one");
  EXPECT_EQ(scene.motions[1].label, "two");
  for (const Panel& panel : scene.motions) {
    EXPECT_EQ(panel.body.mass, 3);
    EXPECT_EQ(panel.simulation.model, Model::Matrix);
    EXPECT_EQ(panel.simulation.timePerFrame, 0.5);
    EXPECT_EQ(panel.simulation.substeps, 64);
    EXPECT_EQ(panel.initial.value, Eigen::Vector3d(0, 0, 6));
    EXPECT_EQ(panel.initial.tilt, (physics::Tilt{0.1, 0}));
    ASSERT_EQ(panel.expectations.size(), 1U);
    EXPECT_EQ(panel.expectations[0].max, 2);
  }
}

TEST(Panels, HaveKeysOfTheirOwn) {
  const Scene scene = sceneOf(
      twoPanels("body.size = [1, 2, 3]\nbody.inertia = [1, 2, 2.5]\nsimulation.model = 'matrix'\n"
                "simulation.integrator = 'dmv6'\nsimulation.substeps = 7\n"
                "initial.angular_velocity = [5, 0, 0]\ninitial.tilt = [0.2, 'y']\n"
                "expect.stretch = { max = 3 }\n"));
  const Panel& one = scene.motions[0];
  EXPECT_EQ(one.simulation.model, Model::Quaternion);
  EXPECT_EQ(one.initial.value, Eigen::Vector3d(0, 0, 6));
  EXPECT_FALSE(one.inertia);
  EXPECT_TRUE(one.expectations.empty());
  const Panel& two = scene.motions[1];
  EXPECT_EQ(two.body.size, Eigen::Vector3d(1, 2, 3));
  EXPECT_TRUE(two.inertia);
  EXPECT_EQ(two.simulation.model, Model::Matrix);
  EXPECT_EQ(two.simulation.integrator, Integrator::Dmv6);
  EXPECT_EQ(two.simulation.substeps, 7);
  EXPECT_EQ(two.initial.value, Eigen::Vector3d(5, 0, 0));
  EXPECT_EQ(two.initial.tilt, (physics::Tilt{0.2, 1}));
  ASSERT_EQ(two.expectations.size(), 1U);
  EXPECT_EQ(two.expectations[0].measure, Measure::Stretch);
}

TEST(Panels, ReplaceTheScenesSpinWhicheverKeyEitherHas) {
  const Panel panel = sceneOf(twoPanels("initial.angular_momentum = [1, 2, 3]")).motions[1];
  EXPECT_EQ(panel.initial.kind, InitialSpin::Kind::AngularMomentum);
  EXPECT_EQ(panel.initial.value, Eigen::Vector3d(1, 2, 3));
}

TEST(Panels, ReplaceTheScenesExpectationsOfTheSameQuantity) {
  const Scene scene = sceneOf(
      "[initial]\nangular_velocity = [0, 0, 6]\n[expect]\nstretch.max = 2\ntilt_deg.max = 3\n"
      "[[panel]]\nlabel = 'one'\nexpect.stretch.min = 1\n[[panel]]\nlabel = 'two'\n");
  ASSERT_EQ(scene.motions[0].expectations.size(), 2U);
  EXPECT_EQ(scene.motions[0].expectations[0].min, 1);
  EXPECT_FALSE(scene.motions[0].expectations[0].max);
  EXPECT_EQ(scene.motions[0].expectations[1].measure, Measure::TiltDeg);
}

TEST(Panels, MayHaveASpinEachInsteadOfTheScenes) {
  const std::string one = "[[panel]]\nlabel = 'one'\ninitial.angular_velocity = [1, 0, 0]\n";
  const Scene scene = sceneOf("[initial]\ntilt = [0.1, 'z']\n" + one +
                              "[[panel]]\nlabel = 'two'\ninitial.angular_velocity = [0, 1, 0]\n");
  EXPECT_EQ(scene.motions[0].initial.value, Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(scene.motions[1].initial.value, Eigen::Vector3d(0, 1, 0));
  EXPECT_EQ(scene.motions[1].initial.tilt, (physics::Tilt{0.1, 2}));
  EXPECT_EQ(errorOfText(one + "[[panel]]\nlabel = 'two'\n"),
            "a.toml:4:1: the panel \"two\" has no [initial], and neither has the scene; it needs "
            "angular_velocity or angular_momentum");
  EXPECT_EQ(errorOfText(one + "[[panel]]\nlabel = 'two'\ninitial.tilt = [0.1, 'z']\n"),
            "a.toml:6:1: [initial] needs angular_velocity or angular_momentum");
}

TEST(Panels, HaveTheIntegratorOfTheSceneElseThatOfTheirModel) {
  const std::string panels = twoPanels("simulation.model = 'particles'");
  EXPECT_EQ(sceneOf(panels).motions[0].simulation.integrator, Integrator::Rk4);
  EXPECT_EQ(sceneOf(panels).motions[1].simulation.integrator, Integrator::Euler);
  const std::string rk4 = "[simulation]\nintegrator = 'rk4'\n";
  EXPECT_EQ(sceneOf(rk4 + panels).motions[1].simulation.integrator, Integrator::Rk4);
  const std::string euler = "[simulation]\nintegrator = 'euler'\n";
  EXPECT_EQ(sceneOf(euler + panels).motions[0].simulation.integrator, Integrator::Euler);
}

TEST(Panels, OfTheExactModelHaveNoUseForTheScenesIntegrator) {
  const std::string text =
      "[initial]\nangular_velocity = [0, 0, 6]\n[simulation]\nintegrator = 'rk4'\n"
      "[[panel]]\nlabel = 'one'\n[[panel]]\nlabel = 'two'\nsimulation.model = 'exact'\n";
  EXPECT_EQ(sceneOf(text).motions[0].simulation.integrator, Integrator::Rk4);
  EXPECT_EQ(sceneOf(text).motions[1].simulation.model, Model::Exact);
  EXPECT_EQ(errorOfText(text + "simulation.integrator = 'rk4'"),
            "a.toml:10:25: panel.simulation.integrator = \"rk4\", but the model \"exact\" takes "
            "no steps; leave it out");
}

TEST(Panels, AreRefusedAnIntegratorOrInertiaThatTheirModelDoesNotHave) {
  EXPECT_MESSAGE(errorOfText("[simulation]\nintegrator = 'dmv6'\n" +
                             twoPanels("simulation.model = 'particles'")));
  EXPECT_MESSAGE(
      errorOfText("[body]\ninertia = [1, 2, 2.5]\n" + twoPanels("simulation.model = 'particles'")));
}

TEST(Panels, AreTwoToSix) {
  std::string text = "[initial]\nangular_velocity = [0, 0, 6]\n";
  for (int count = 1; count <= 7; ++count) {
    text += "[[panel]]\nlabel = '" + std::to_string(count) + "'\n";
    const std::string expected =
        2 <= count && count <= 6
            ? "no error"
            : "a.toml:3:1: a scene has 2 to 6 panels, not " + std::to_string(count);
    EXPECT_EQ(errorOfText(text), expected);
  }
  EXPECT_EQ(errorOf("panel = 3"),
            "a.toml:1:9: panel must be tables with the header [[panel]], not 3");
}

TEST(Panels, NeedALabelOfTheirOwn) {
  const std::string one = std::string(kSpin) + "[[panel]]\nlabel = 'one'\n[[panel]]\n";
  EXPECT_EQ(errorOfText(one), "a.toml:5:1: a panel needs a label");
  EXPECT_EQ(errorOfText(one + "label = 3"),
            "a.toml:6:9: panel.label must be a string in quotes, not 3");
  EXPECT_EQ(errorOfText(one + "label = ''"),
            "a.toml:6:9: panel.label must be a string that isn't empty, not \"\"");
  EXPECT_EQ(errorOfText(one + "label = \"two\\nlines\""),
            "a.toml:6:9: panel.label must be a string on one line, without control characters, "
            "not \"two\\nlines\"");
  EXPECT_EQ(errorOfText(one + "label = 'one'"), "a.toml:6:9: two panels have the label \"one\"");
}

TEST(Panels, ShareOneClock) {
  EXPECT_EQ(errorOfText(twoPanels("clip.duration = 3")),
            "a.toml:7:1: a panel has no clip of its own, because all panels share one clock; set "
            "the keys of [clip] for the whole scene");
  EXPECT_EQ(errorOfText(twoPanels("simulation.time_per_frame = 0.01")),
            "a.toml:7:29: a panel has no time_per_frame of its own, because all panels share one "
            "clock; set simulation.time_per_frame for the whole scene");
}

TEST(Panels, NameTheNearestKey) {
  EXPECT_EQ(errorOfText(twoPanels("lable = 'x'")),
            "a.toml:7:1: unknown key \"lable\" in [panel]; did you mean \"label\"?");
  EXPECT_EQ(errorOfText(twoPanels("simulation.modle = 'exact'")),
            "a.toml:7:12: unknown key \"modle\" in [panel.simulation]; did you mean \"model\"?");
  EXPECT_EQ(errorOfText(twoPanels("simulation.model = 'exakt'")),
            "a.toml:7:20: panel.simulation.model must be \"particles\", \"matrix\", "
            "\"quaternion\", \"exact\" or \"recorded\", not \"exakt\"; did you mean \"exact\"?");
  EXPECT_EQ(errorOfText(twoPanels("camera.target = [0, 0, 0]")),
            "a.toml:7:1: unknown key \"camera\" in [panel]; valid are \"label\", \"frame\", "
            "\"body\", \"simulation\", \"initial\", \"nudge\" and \"expect\"");
  EXPECT_EQ(errorOfText(twoPanels("body = 5")), "a.toml:7:8: panel.body must be a section, not 5");
}

TEST(Panels, LeaveNothingToStudy) {
  EXPECT_EQ(
      errorOfText(twoPanels("[study]")),
      "a.toml:7:1: [study] needs a single motion, but this scene has several, panels or a grid");
}

TEST(Panels, TakeOverridesByTheirNumber) {
  const std::string text = twoPanels("initial.angular_momentum = [1, 2, 3]");
  const Scene scene = sceneOf(
      text, {"panel.0.simulation.model=exact", "panel.1.initial.angular_velocity=[3, 2, 1]"});
  EXPECT_EQ(scene.motions[0].simulation.model, Model::Exact);
  EXPECT_EQ(scene.motions[1].simulation.model, Model::Quaternion);
  EXPECT_EQ(scene.motions[1].initial.kind, InitialSpin::Kind::AngularVelocity);
  EXPECT_EQ(scene.motions[1].initial.value, Eigen::Vector3d(3, 2, 1));
  const Scene deep =
      sceneOf(text + "\n[expect]\nhalf_turns = [{ min = 1 }, { max = 9 }]\n",
              {"panel.0.initial.angular_velocity=[3, 2, 1]", "panel.0.initial.angular_velocity.0=5",
               "panel.1.expect.half_turns.min=2", "expect.half_turns.1.max=8"});
  EXPECT_EQ(deep.motions[0].initial.value, Eigen::Vector3d(5, 2, 1));
  ASSERT_EQ(deep.motions[0].expectations.size(), 2U);
  EXPECT_EQ(deep.motions[0].expectations[1].max, 8);
  ASSERT_EQ(deep.motions[1].expectations.size(), 1U);
  EXPECT_EQ(deep.motions[1].expectations[0].min, 2);
  EXPECT_EQ(errorOfText(text, {"panel.2.label=x"}),
            "--set panel.2.label=x: panel has 2 elements, numbered from 0, and no \"2\"");
  EXPECT_EQ(errorOfText(text, {"panel.one.label=x"}),
            "--set panel.one.label=x: panel has 2 elements, numbered from 0, and no \"one\"");
}

TEST(Panels, ReadBackFromTheirText) {
  const Scene scene = sceneOf(
      "[simulation]\ntime_per_frame = 0.25\nintegrator = 'rk4'\n[body]\nmass = 2\n[expect]\n"
      "stretch.max = 2\n" +
      twoPanels("body.inertia = [1, 2, 2.5]\nsimulation.model = 'exact'\n"
                "initial.angular_momentum = [1, 2, 3]\ninitial.tilt = [0.2, 'y']\n"
                "expect.half_turns = [{ min = 3, to = 4 }, { max = 9 }]\n"));
  const std::string text = sceneText(scene);
  SCOPED_TRACE(text);
  const Scene back = sceneOf(text);
  ASSERT_EQ(back.motions.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const Panel &read = back.motions[i], &meant = scene.motions[i];
    EXPECT_EQ(read.label, meant.label);
    EXPECT_EQ(read.body.mass, 2);
    EXPECT_EQ(read.inertia, meant.inertia);
    EXPECT_EQ(read.simulation.model, meant.simulation.model);
    EXPECT_EQ(read.simulation.timePerFrame, 0.25);
    EXPECT_EQ(read.initial.kind, meant.initial.kind);
    EXPECT_EQ(read.initial.value, meant.initial.value);
    EXPECT_EQ(read.initial.tilt, meant.initial.tilt);
    EXPECT_EQ(read.expectations.size(), meant.expectations.size());
  }
  EXPECT_EQ(back.motions[0].simulation.integrator, Integrator::Rk4);
  EXPECT_EQ(back.motions[1].expectations, scene.motions[1].expectations);
  EXPECT_EQ(sceneText(back), text);
  EXPECT_THAT(text, Not(HasSubstr("\n[initial]")));
}

TEST(Panels, AreSeenWholeByTheDefaultCamera) {
  const Scene scene = sceneOf(twoPanels("body.size = [1, 2, 3]"));
  EXPECT_EQ(scene.cameraPosition, defaultCameraPosition(scene.motions[1].body, 30, 1, 1));
}

TEST(Panels, AreSeenInTheirOwnFrames) {
  const Scene scene = sceneOf(
      "camera.frame = 'momentum'\n[initial]\nangular_velocity = [0, 3, 6]\n"
      "[[panel]]\nlabel = 'A'\nframe = 'body'\n[[panel]]\nlabel = 'B'\n");
  physics::Sample sample;
  sample.attitude = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX());
  sample.angularMomentum = {1, 2, 3};
  const auto frames = referenceFramesOf(scene);
  ASSERT_EQ(frames.size(), 2U);
  const auto in = [&](ReferenceFrame frame) { return MotionFrame(frame).fromWorld(sample); };
  EXPECT_EQ(frames[0].fromWorld(sample), in(ReferenceFrame::Body));
  EXPECT_EQ(frames[1].fromWorld(sample), in(ReferenceFrame::Momentum));
  const Scene alone = withMotion(scene, scene.motions[0]);
  EXPECT_EQ(referenceFramesOf(alone).front().fromWorld(sample), in(ReferenceFrame::Body));
  const std::string text = sceneText(scene);
  EXPECT_THAT(text, HasSubstr("label = \"A\"\nframe = \"body\""));
  EXPECT_EQ(sceneText(sceneOf(text)), text);
}

TEST(MotionsOf, AreThePanelsOrTheSceneItself) {
  const Scene scene = sceneOf(twoPanels("body.mass = 7"));
  EXPECT_EQ(scene.motions.size(), 2U);
  const Scene single = withMotion(scene, scene.motions[1]);
  EXPECT_EQ(single.motions[0].body.mass, 7);
  const auto motions = single.motions;
  ASSERT_EQ(motions.size(), 1U);
  EXPECT_EQ(motions[0].label, "");
  EXPECT_EQ(motions[0].body.mass, 7);
}

}  // namespace
}  // namespace rotatebook::scene
