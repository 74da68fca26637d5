// simulation.step, substeps and time_per_frame: the steps of a motion.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "messages.h"
#include "scene/parse.h"
#include "scene/scene_text.h"

namespace rotatebook::scene {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr double kStep = 1.0 / 3840;  // 64 in 1/60 s

double stepOf(const Scene& scene) {
  return scene.motions[0].simulation.steps().length();
}

TEST(Steps, DependOnNeitherRateNorSpeedNorSize) {
  for (const std::string lines :
       {"", "clip.fps = 25", "clip.fps = '30000/1001'", "clip.speed = 0.25",
        "clip.speed = [{ from = 1, to = 2, value = 0.5 }]", "clip.size = [64, 36]"}) {
    EXPECT_EQ(stepOf(sceneFrom(lines)), kStep) << lines;
  }
  EXPECT_EQ(stepOf(sceneFrom("clip.fps = 25\nsimulation.time_per_frame = 0.64")), 0.01);
}

TEST(Steps, MayBeStatedByTheirLength) {
  const Scene scene = sceneFrom("simulation.step = '5 ms'");
  EXPECT_EQ(stepOf(scene), 0.005);
  EXPECT_EQ(scene.timePerFrame(), 1.0 / 60);
  EXPECT_THAT(sceneText(scene), HasSubstr("\nstep = 0.005  # s"));
  EXPECT_THAT(sceneText(scene), Not(HasSubstr("\nsubsteps")));
  EXPECT_EQ(parseScene(sceneText(scene), "a.toml").motions[0].simulation,
            scene.motions[0].simulation);
  EXPECT_EQ(errorOf("[simulation]\nstep = 0"),
            "a.toml:2:8: simulation.step must be a time from 1e-9 to 1e9 s, not 0");
  EXPECT_EQ(errorOf("[simulation]\nstep = 0.1\nsubsteps = 3"),
            "a.toml:2:8: both simulation.step and simulation.substeps say how long a step is; "
            "keep one");
}

TEST(Steps, ThatAreCloserReplaceTheOthers) {
  const std::vector<std::string> substeps{"simulation.substeps=2"}, step{"simulation.step=0.125"};
  EXPECT_EQ(stepOf(sceneFrom("simulation.step = 0.5", substeps)), 1.0 / 120);
  EXPECT_EQ(stepOf(sceneFrom("simulation.substeps = 3", step)), 0.125);
  const Scene panels = sceneFrom(
      "simulation.step = 0.5\n[[panel]]\nlabel = 'a'\n[[panel]]\nlabel = 'b'\n"
      "simulation.substeps = 2");
  EXPECT_EQ(panels.motions[0].simulation.steps().length(), 0.5);
  EXPECT_EQ(panels.motions[1].simulation.steps().length(), 1.0 / 120);
  EXPECT_EQ(parseScene(sceneText(panels), "a.toml").motions, panels.motions);
}

TEST(Steps, VaryInGridsStudiesAndMaps) {
  const std::string values = "key = 'simulation.step', values = ['10 ms', '1 ms']";
  const Scene grid = sceneFrom("simulation.substeps = 3\n[grid]\ncolumns = { " + values + " }");
  EXPECT_EQ(grid.motions[1].simulation.steps().length(), 0.001);
  const Scene study = sceneFrom(
      "simulation.substeps = 3\n[study]\nx = { key = 'simulation.step', values = [0.01, 0.001] }\n"
      "measure = ['half_turns']");
  EXPECT_EQ(study.runs[1].motion.simulation.steps().length(), 0.001);
  EXPECT_EQ(study.runs[1].motion.simulation.timePerFrame, 1.0 / 60);
  EXPECT_EQ(errorOf("[map]\nx = { key = 'simulation.step', from = 0.001, to = 0.1 }\n"
                    "y = { key = 'initial.angular_velocity.2', from = 1, to = 2 }\n"
                    "measure = 'half_turns'"),
            "no error");
}

TEST(Steps, OfAStudyAreThoseOfTheMotionWhateverItsSamples) {
  const Scene scene = sceneFrom(
      "[study]\ninterval = 0.25\nx = { key = 'simulation.substeps', values = [64] }\n"
      "measure = ['half_turns']");
  const physics::MotionSettings& motion = scene.runs[0].motion;
  EXPECT_EQ(motion.simulation.timePerFrame, 0.25);
  EXPECT_EQ(motion.simulation.steps().length(), kStep);
}

TEST(Steps, AreFoundUnderOtherNames) {
  for (const std::string key : {"dt", "timestep", "time_step", "step_size"}) {
    EXPECT_MESSAGE(errorOf("[simulation]\n" + key + " = 0.001")) << key;
  }
}

TEST(Messages, GuessWhatIsMeantByOtherWords) {
  EXPECT_MESSAGE(errorOf("[clip]\nslow_motion = 0.2"));
  EXPECT_MESSAGE(errorOf("[book]\ncover = 'a.png'"));
  EXPECT_MESSAGE(errorOf("overlay.words = 'deutsch'"));
  EXPECT_MESSAGE(errorOf("clip.duration = '20 sec'"));
  EXPECT_MESSAGE(errorOfText("[initial]\nangular_velocity = { about = 'median', value = 4 }"));
  const std::string tilted = "[initial]\nangular_velocity = [5, 0, 0]\ntilt = ";
  EXPECT_MESSAGE(errorOfText(tilted + "['1 degree', 'z']"));
  EXPECT_EQ(errorOfText(tilted + "['1°', 'z']"), "no error");
  EXPECT_EQ(errorOfText("[initial]\nangular_velocity = ['300 °/s', 0, 0]"), "no error");
}

TEST(Messages, AskForTheAxisOfASpeed) {
  const std::string must =
      " names no axis; write three numbers, such as [5, 0, 0], or { about = \"middle\", value = "
      "\"48 rpm\" }";
  EXPECT_EQ(errorOfText("[initial]\nangular_velocity = '48 rpm'"),
            "a.toml:2:20: initial.angular_velocity = \"48 rpm\"" + must);
  EXPECT_EQ(
      errorOfText("[initial]\nangular_velocity = '48 rpn'"),
      "a.toml:2:20: initial.angular_velocity = \"48 rpn\"" + must + "; did you mean \"rpm\"?");
}

TEST(Messages, ListTheIntegratorsOfTheModel) {
  EXPECT_EQ(errorOf("[simulation]\nmodel = 'matrix'\nintegrator = 'RK4'"),
            "a.toml:3:14: simulation.integrator must be " +
                listOfIntegrators("or", physics::Model::Matrix) +
                ", not \"RK4\"; did you mean \"rk4\"?");
  EXPECT_MESSAGE(errorOf("[simulation]\nintegrator = 'RK4'\nsubsteps = 0"));
}

TEST(Messages, NameAllMistakesOfAList) {
  const std::string message = errorOf("[overlay]\nshow = ['half-turns', 'Omega']");
  EXPECT_MESSAGE(message);
  EXPECT_MESSAGE(message);
  const std::string study = errorOf(
      "[study]\ncurves = { key = 'simulation.integrator', values = ['rk5', 'eulr'] }\n"
      "x = { key = 'simulation.substeps', values = [1] }");
  for (const char* part : {"\"rk5\"", "\"eulr\""}) EXPECT_THAT(study, HasSubstr(part));
  EXPECT_THAT(errorOf("body.size = ['1 foot', 2, -3]"),
              testing::AllOf(HasSubstr("\"1 foot\""), HasSubstr("not -3")));
}

}  // namespace
}  // namespace rotatebook::scene
