// [study] over any key: what is read, what each run's motion is, and what is refused.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/parse.h"
#include "scene/scene_text.h"

namespace rotatebook::scene {
namespace {

using physics::Model;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

Sweep sweepOf(const std::string& lines, const std::vector<std::string>& overrides = {}) {
  return *sceneFrom("[study]\n" + lines, overrides).study->sweep;
}

std::vector<std::string> labelsOf(const Axis& axis) {
  std::vector<std::string> labels;
  for (const AxisValue& value : axis.values) labels.push_back(value.label);
  return labels;
}

std::string overSubsteps(const std::string& values) {
  return "x = { key = 'simulation.substeps', " + values + " }\n";
}

/// The labels of the values of a stiffness.
std::vector<std::string> stiffnesses(const std::string& values) {
  return labelsOf(sweepOf("measure = ['stretch']\n"
                          "curves = { key = 'simulation.model', values = ['particles'] }\n"
                          "x = { key = 'simulation.stiffness', " +
                          values + " }")
                      .x);
}

/// The message about [study] over substeps with these values, in the third line, and these lines
/// thereafter.
std::string errorOfSweep(const std::string& values, const std::string& lines = "") {
  return errorOf("[study]\nmeasure = ['error_deg']\n" + overSubsteps(values) + lines);
}

TEST(SweepSection, HasAMotionForEachValue) {
  const Sweep sweep =
      sweepOf(overSubsteps("values = [10, 1000]") + "measure = ['diverges_at', 'half_turns']");
  ASSERT_EQ(sweep.runs.size(), 2U);
  EXPECT_EQ(sweep.runs[0].value, "10");
  EXPECT_EQ(sweep.runs[0].motion.simulation.substeps, 10);
  EXPECT_EQ(sweep.runs[1].motion.simulation.substeps, 1000);
  physics::MotionSettings rest = sceneFrom("").motion();
  rest.simulation.substeps = 1000;
  EXPECT_EQ(sweep.runs[1].motion, rest);
  EXPECT_THAT(sweep.measures, ElementsAre(Measure::DivergesAt, Measure::HalfTurns));
  EXPECT_EQ(sweep.x.values[0].number, 10.0);
}

TEST(SweepSection, HasThemForEachCurve) {
  const Sweep sweep =
      sweepOf(overSubsteps("values = [1, 2]") +
              "measure = ['error_deg']\n"
              "curves = { key = 'simulation.model', values = ['matrix', 'exact'] }");
  ASSERT_EQ(sweep.runs.size(), 4U);
  EXPECT_EQ(sweep.runs[1].curve, "matrix");
  EXPECT_EQ(sweep.runs[1].value, "2");
  EXPECT_EQ(sweep.runs[2].curve, "exact");
  EXPECT_EQ(sweep.runs[2].motion.simulation.model, Model::Exact);
  EXPECT_EQ(sweep.runs[2].motion.simulation.substeps, 1);
}

TEST(SweepSection, TakesRanges) {
  EXPECT_THAT(stiffnesses("from = 10, to = 1000, count = 3, scale = 'log'"),
              ElementsAre("10", "100", "1000"));
  EXPECT_THAT(stiffnesses("from = 1.0, to = 2, count = 3"), ElementsAre("1", "1.5", "2"));
  EXPECT_THAT(stiffnesses("from = 1, to = 4, count = 3"), ElementsAre("1", "3", "4"))
      << "whole, as its ends are";
  EXPECT_THAT(stiffnesses("from = 1.0, to = 100.0, count = 4, scale = 'log'"),
              ElementsAre("1", "4.64159", "21.5443", "100"));
}

TEST(SweepSection, TakesAnyValueWithALabel) {
  const Sweep sweep = sweepOf(
      "measure = ['error_deg']\nx = { key = 'initial.angular_velocity', "
      "values = [{ label = 'x', value = [4, 0, 0] }, { label = 'y', value = [0, 4, 0] }] }");
  EXPECT_THAT(labelsOf(sweep.x), ElementsAre("x", "y"));
  EXPECT_EQ(sweep.runs[1].motion.initial.value, Eigen::Vector3d(0, 4, 0));
  EXPECT_FALSE(sweep.x.values[0].number.has_value());
}

TEST(SweepSection, ReplacesOneSpinByTheOther) {
  const Sweep sweep = sweepOf(
      "measure = ['error_deg']\nx = { key = 'initial.angular_momentum', "
      "values = [{ label = 'x', value = [0.1, 0, 0] }] }");
  EXPECT_EQ(sweep.runs[0].motion.initial.kind, physics::SpinKind::AngularMomentum);
}

TEST(SweepSection, ReachesIntoTablesArraysAndNudges) {
  const Sweep every = *sceneFrom(
                           "[simulation]\nnormalize = { every = 1 }\n[study]\n"
                           "x = { key = 'simulation.normalize.every', values = [1, 50] }\n"
                           "measure = ['error_deg']")
                           .study->sweep;
  EXPECT_EQ(every.runs[1].motion.simulation.normalizeEvery, 50);
  const Scene nudged = sceneFrom(
      "[[nudge]]\nat = 1\nangular_velocity = [0, 1, 0]\n[study]\n"
      "x = { key = 'nudge.0.at', values = [2, 3.5] }\nmeasure = ['half_turns']");
  EXPECT_EQ(nudged.study->sweep->runs[1].motion.nudges.at(0).at, 3.5);
}

TEST(SweepSection, ReadsBackTheSameFromItsText) {
  const Scene scene = sceneFrom(
      "[study]\nmeasure = ['diverges_at', 'stretch']\nx = { key = 'initial.angular_velocity', "
      "values = [{ label = 'x', value = [4.5, 0, 0] }, { label = 'the y', value = [0, 4, 0] }], "
      "label = 'spin' }\n"
      "curves = { key = 'simulation.normalize', values = [true, { label = 'seldom', value = "
      "{ every = 9 } }] }\n"
      "expect = [{ of = 'stretch', x = 'x', curve = 'seldom', max = 2 }]");
  EXPECT_EQ(scene.study->sweep->runs[3].motion.simulation.normalizeEvery, 9);
  EXPECT_EQ(*parseScene(sceneText(scene), "a.toml").study, *scene.study);
}

TEST(SweepSection, NamesTheKeyThatIsNone) {
  const auto errorOver = [](const std::string& key) {
    return errorOf("[study]\nx = { key = '" + key + "', values = [1] }\nmeasure = ['error_deg']");
  };
  EXPECT_EQ(errorOver("simulation.substep"),
            "a.toml:2:13: unknown key \"substep\" in [simulation]; did you mean \"substeps\"?");
  EXPECT_THAT(errorOver("simulatio.substeps"),
              AllOf(HasSubstr("a.toml:2:13: study.x.key must be a key of "),
                    HasSubstr("did you mean \"simulation\"?")));
  EXPECT_THAT(errorOver("clip.fps"), HasSubstr("study.x.key must be a key of "));
  EXPECT_THAT(errorOver("body"),
              AllOf(HasSubstr("study.x.key must be a key of "), Not(HasSubstr("did you mean"))));
  EXPECT_THAT(errorOver("expect.stretch"), HasSubstr("study.x.key must be a key of "));
}

TEST(SweepSection, NamesTheValueThatIsWrong) {
  EXPECT_EQ(errorOfSweep("values = [10, 0]"),
            "a.toml:3:50: simulation.substeps must be an integer from 1 to 1000000, not 0");
  EXPECT_EQ(errorOfSweep("values = [10, 10]"), "a.toml:3:50: study.x.values has 10 twice");
  EXPECT_THAT(errorOfSweep("from = 0, to = 9, count = 3, scale = 'log'"),
              HasSubstr("is logarithmic, which needs from over 0, not 0.0"));
  EXPECT_THAT(errorOfSweep("from = 1, to = 3, count = 9"),
              HasSubstr("has 1 twice; between whole numbers all are whole: lower count"));
  EXPECT_THAT(errorOfSweep("from = 1, count = 9"),
              HasSubstr("needs either values, or from, to and count"));
  EXPECT_THAT(errorOfSweep("values = [[1, 2]]"), HasSubstr("must be a number, a word, or a table"));
  EXPECT_THAT(errorOfSweep("values = [{ label = '', value = 1 }]"), HasSubstr("must be a word"));
}

TEST(SweepSection, RefusesWhatCannotBeMeasuredOrExpected) {
  const auto errorExpecting = [](const std::string& expected) {
    return errorOfSweep("values = [10, 20]", "expect = " + expected);
  };
  EXPECT_EQ(errorExpecting("[{ of = 'stretch', max = 1 }]"),
            "a.toml:4:18: stretch isn't in study.measure");
  EXPECT_EQ(errorExpecting("[{ of = 'error_deg', x = 30, max = 1 }]"),
            "a.toml:4:35: study.expect.x = 30 is no value of study.x");
  EXPECT_EQ(errorExpecting("[{ of = 'error_deg', curve = 'x', max = 1 }]"),
            "a.toml:4:39: study.expect.curve needs study.curves");
  EXPECT_EQ(errorExpecting("[{ of = 'error_deg' }]"),
            "a.toml:4:11: study.expect needs min, max or both");
  EXPECT_EQ(errorExpecting("[]"), "no error");
}

TEST(SweepSection, IsAloneAndWhole) {
  EXPECT_THAT(errorOfSweep("values = [1]", "steps = [1]"), HasSubstr("has both x and steps"));
  EXPECT_EQ(errorOf("[study]\n" + overSubsteps("values = [1]")),
            "a.toml:1:1: [study] has x, so it needs measure");
  EXPECT_EQ(errorOf("[study]\nmeasure = ['stretch']"), "a.toml:2:11: study.measure needs study.x");
  EXPECT_THAT(
      errorOfSweep("values = [1]", "curves = { key = 'simulation.substeps', values = [1] }"),
      HasSubstr("study.curves.key is study.x.key, too"));
}

TEST(SweepSection, IsLimited) {
  EXPECT_THAT(errorOfSweep("from = 1, to = 900, count = 900",
                           "curves = { key = 'simulation.normalize', values = [true, false] }"),
              HasSubstr("[study] has 1800 runs; the limit is 1000"));
  EXPECT_THAT(errorOfSweep("from = 1, to = 1000000, count = 900", "[clip]\nduration = 60"),
              HasSubstr("make fewer runs, or shorter ones"));
}

TEST(SweepSection, RefusesAnIntervalInPlaceOfTheOneThatItVaries) {
  EXPECT_EQ(errorOf("[study]\nx = { key = 'simulation.time_per_frame', values = [0.1] }\n"
                    "measure = ['half_turns']\ninterval = 0.01"),
            "a.toml:4:12: study.interval replaces simulation.time_per_frame, which the study "
            "varies; remove one of them");
}

// Where only the start varies, the springs' eigenvalues are solved once.
TEST(SweepSection, SettlesTheBodyOnceForAllStarts) {
  const std::string particles =
      "[simulation]\nmodel = 'particles'\nparticles = 'grid:7'\nsubsteps = 300\n";
  const auto runsOf = [&](const std::string& keyAndValues) {
    const std::string start = "[initial]\nangular_velocity = [4, 0, 0]\ntilt = [0.1, 'z']\n";
    return parseScene(start + particles +
                          "[study]\nmeasure = ['tilt_deg']\nx = { key = " + keyAndValues + " }",
                      "a.toml")
        .study->sweep->runs;
  };
  for (const char* lines :
       {"'initial.tilt.0', values = [0.2, '3 deg', 1]", "'initial.tilt', values = [0.2, 1]",
        "'initial.tilt', values = [{ label = 'y', value = [0.2, 'y'] }, "
        "{ label = 'x', value = ['1 deg', 'z'] }]",
        "'initial.tilt.1', values = ['z', 'y']",
        "'initial.angular_velocity.1', values = [0.2, 1]"}) {
    const std::vector<SweepRun> runs = runsOf(lines);
    EXPECT_NE(runs[0].motion, runs[1].motion) << lines;
    for (const SweepRun& run : runs)
      EXPECT_EQ(run.motion.particles.system, runs[0].motion.particles.system) << lines;
  }
  const std::vector<SweepRun> masses = runsOf("'body.mass', values = [1, 2]");
  EXPECT_NE(masses[0].motion.particles.system, masses[1].motion.particles.system);
}

TEST(SweepSection, GivesStartsAsIfTheyStoodInTheScene) {
  const std::string start = "[initial]\nangular_velocity = [4, 0, 0]\ntilt = [0.1, 'z']\n";
  const Scene scene = parseScene(
      start +
          "[study]\nmeasure = ['tilt_deg']\nx = { key = 'initial.tilt.0', values = ['3 deg', 1] }",
      "a.toml");
  for (const SweepRun& run : scene.study->sweep->runs) {
    const Scene stated = parseScene(start, "a.toml", std::vector{"initial.tilt.0=" + run.value});
    EXPECT_EQ(run.motion, stated.motion()) << run.value;
  }
  EXPECT_THAT(errorOfText(start + "[study]\nmeasure = ['tilt_deg']\n"
                                  "x = { key = 'initial.tilt.0', values = [0.1, 1e7] }"),
              HasSubstr("a.toml:6:46: initial.tilt must be an angle from -1e6 to 1e6 rad"));
}

TEST(SweepSection, RefusesToVaryWhatNoRunHas) {
  const std::string rest = "', values = [1, 2] }\nmeasure = ['half_turns']";
  EXPECT_EQ(errorOf("[study]\nx = { key = 'simulation.stiffness" + rest),
            "a.toml:2:13: simulation.stiffness is of the model \"particles\" alone; "
            "all runs would be the same");
  EXPECT_EQ(errorOf("[study]\nx = { key = 'simulation.stiffness" + rest +
                    "\ncurves = { key = 'simulation.model', values = ['matrix', 'particles'] }"),
            "no error");
}

}  // namespace
}  // namespace rotatebook::scene
