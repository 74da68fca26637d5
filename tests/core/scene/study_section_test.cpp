// [study]: what is read, what each run's motion is, and what is refused.
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "messages.h"
#include "scene/key_rows.h"
#include "scene/parse.h"
#include "scene/scene_text.h"

namespace rotatebook::scene {
namespace {

using physics::Model;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

StudySettings studyOf(const std::string& lines, const std::vector<std::string>& overrides = {}) {
  return *sceneFrom("[study]\n" + lines, overrides).study;
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
  return labelsOf(studyOf("measure = ['stretch']\n"
                          "curves = { key = 'simulation.model', values = ['particles'] }\n"
                          "x = { key = 'simulation.stiffness', " +
                          values + " }")
                      .x);
}

/// The message about [study] over substeps with these values, in the third line, and these lines
/// thereafter.
std::string errorOfStudy(const std::string& values, const std::string& lines = "") {
  return errorOf("[study]\nmeasure = ['error_deg']\n" + overSubsteps(values) + lines);
}

TEST(StudySection, IsNotThereUnlessWritten) {
  EXPECT_FALSE(sceneFrom("").study.has_value());
}

TEST(StudySection, FindsTheOrdersOfEveryIntegratorByDefault) {
  const StudySettings rigid = studyOf("");
  EXPECT_EQ(rigid.x.key, "simulation.substeps");
  EXPECT_THAT(labelsOf(rigid.x),
              ElementsAre("1", "2", "4", "8", "16", "32", "64", "128", "256", "512", "1024"));
  EXPECT_EQ(rigid.curves->key, "simulation.integrator");
  EXPECT_EQ(rigid.curves->values.size(), 14U);
  EXPECT_EQ(sceneFrom("[study]").runs.size(), 14U * 11);
  EXPECT_THAT(rigid.measures, ElementsAre(Measure::Order));
  const StudySettings particles = *sceneFrom("simulation.model = 'particles'\n[study]").study;
  EXPECT_THAT(labelsOf(*particles.curves),
              ElementsAre("euler", "rk4", "symplectic-euler", "verlet"));
  EXPECT_FALSE(studyOf("measure = ['half_turns']").curves.has_value());
}

TEST(StudySection, FindsOrdersFromDifferentStepsAlone) {
  EXPECT_EQ(
      sceneFrom("[study]\nx = { key = 'simulation.step', values = ['1 ms', '2 ms'] }").runs.size(),
      28U);
  EXPECT_EQ(errorOf("[study]\nx = { key = 'body.mass', values = [1, 2] }"),
            "a.toml:2:5: order, which is measured unless study.measure says otherwise, is found "
            "from different steps, but study.x gives two runs the same; vary simulation.substeps "
            "or simulation.step, or state another measure");
  const std::string expected = "[study]\nexpect = [{ of = 'order', ";
  EXPECT_EQ(errorOf(expected + "x = 1, min = 3 }]"),
            "a.toml:2:31: order is of a whole curve; leave x out");
  EXPECT_EQ(errorOf(expected + "curve = 'rk4', min = 3 }]"), "no error");
}

TEST(StudySection, RefusesOrdersOfAMotionWithoutSteps) {
  EXPECT_EQ(errorOf("simulation.model = 'exact'\n[study]"),
            "a.toml:2:1: the model \"exact\" takes no steps, whose order [study] finds without a "
            "measure; state x and measure, or choose another model");
  EXPECT_EQ(errorOf("simulation.model = 'exact'\n[study]\nmeasure = ['order']\n"
                    "x = { key = 'body.mass', values = [1] }"),
            "a.toml:3:11: study.measure has order: the motion takes no steps; choose another "
            "model, e.g. simulation.model = \"quaternion\"");
}

TEST(StudySection, RefusesIntegratorsThatTheModelDoesNotHave) {
  EXPECT_EQ(errorOf("[simulation]\nmodel = 'particles'\n[study]\n"
                    "curves = { key = 'simulation.integrator', values = ['euler', 'dmv6'] }"),
            "a.toml:4:62: simulation.integrator = \"dmv6\", but the model \"particles\" has "
            "\"euler\", \"rk4\", \"symplectic-euler\" and \"verlet\"");
}

TEST(StudySection, RefusesASingleSample) {
  EXPECT_EQ(errorOf("clip.duration = 0.01\n[study]"),
            "a.toml:2:1: [study] takes a single sample of a motion, which shows none; raise "
            "study.duration or clip.duration");
}

TEST(StudySection, HasAMotionForEachValue) {
  const Scene scene = sceneFrom("[study]\n" + overSubsteps("values = [10, 1000]") +
                                "measure = ['diverges_at', 'half_turns']");
  const StudySettings& study = *scene.study;
  ASSERT_EQ(scene.runs.size(), 2U);
  EXPECT_EQ(scene.runs[0].value, "10");
  EXPECT_EQ(scene.runs[0].motion.simulation.substeps, 10);
  EXPECT_EQ(scene.runs[1].motion.simulation.substeps, 1000);
  physics::MotionSettings rest = sceneFrom("").motions[0];
  rest.simulation.substeps = 1000;
  EXPECT_EQ(scene.runs[1].motion, rest);
  EXPECT_THAT(study.measures, ElementsAre(Measure::DivergesAt, Measure::HalfTurns));
  EXPECT_EQ(study.x.values[0].number, 10.0);
}

TEST(StudySection, HasThemForEachCurve) {
  const Scene scene =
      sceneFrom("[study]\n" + overSubsteps("values = [1, 2]") +
                "measure = ['error_deg']\n"
                "curves = { key = 'simulation.model', values = ['matrix', 'exact'] }");
  ASSERT_EQ(scene.runs.size(), 4U);
  EXPECT_EQ(scene.runs[1].curve, "matrix");
  EXPECT_EQ(scene.runs[1].value, "2");
  EXPECT_EQ(scene.runs[2].curve, "exact");
  EXPECT_EQ(scene.runs[2].motion.simulation.model, Model::Exact);
  EXPECT_EQ(scene.runs[2].motion.simulation.substeps, 1);
}

TEST(StudySection, TakesRanges) {
  EXPECT_THAT(stiffnesses("from = 10, to = 1000, count = 3, scale = 'log'"),
              ElementsAre("10", "100", "1000"));
  EXPECT_THAT(stiffnesses("from = 1.0, to = 2, count = 3"), ElementsAre("1", "1.5", "2"));
  EXPECT_THAT(stiffnesses("from = 1, to = 4, count = 3"), ElementsAre("1", "3", "4"))
      << "whole, as its ends are";
  EXPECT_THAT(stiffnesses("from = 1.0, to = 100.0, count = 4, scale = 'log'"),
              ElementsAre("1", "4.64159", "21.5443", "100"));
}

TEST(StudySection, TakesRangesWithUnits) {
  const std::string x = "x = { key = 'simulation.step', from = '1 ms', to = '10 ms', count = 3 }\n";
  const Scene scene = sceneFrom("[study]\nmeasure = ['error_deg']\n" + x);
  EXPECT_THAT(labelsOf(scene.study->x), ElementsAre("0.001", "0.0055", "0.01"));
  EXPECT_EQ(nameOf(scene.study->x), "simulation.step  [s]");
  EXPECT_EQ(scene.runs[1].motion.simulation.step, 0.0055);
  EXPECT_THAT(sceneText(scene), HasSubstr("values = [0.001, 0.0055, 0.01]"));
  EXPECT_EQ(*parseScene(sceneText(scene), "a.toml").study, *scene.study);
  const auto masses = [](const std::string& ends) {
    return labelsOf(studyOf("measure = ['error_deg']\nx = { " + ends + ", key = 'body.mass' }").x);
  };
  EXPECT_THAT(masses("from = '500 g', to = 2, count = 4"), ElementsAre("0.5", "1", "1.5", "2"));
  EXPECT_THAT(masses("from = 1, to = '100 kg', count = 3, scale = 'log'"),
              ElementsAre("1", "10", "100"));
}

TEST(StudySection, NamesTheUnitsOfARangesEnds) {
  const auto errorFrom = [](const std::string& key, const std::string& from) {
    return errorOf("[study]\nmeasure = ['error_deg']\nx = { " + key + "from = '" + from +
                   "', to = 10, count = 3 }");
  };
  EXPECT_EQ(errorFrom("key = 'simulation.step', ", "1 cm"),
            "a.toml:3:39: study.x.from must be a number, not \"1 cm\"; a text is a number and a "
            "unit, \"s\", \"ms\" or \"min\", such as \"1.5 s\"");
  EXPECT_EQ(errorFrom("key = 'simulation.step', ", "20 s"),
            "a.toml:3:39: study.x runs from 20.0 to 10.0; from must be less than to");
  EXPECT_EQ(errorFrom("key = 'simulation.step', ", "0 s"),
            "a.toml:3:39: simulation.step must be a time from 1e-9 to 1e9 s, not 0.0");
  for (const char* key : {"key = 'simulation.substeps', ", "key = 'simulation.stepp', ", ""}) {
    EXPECT_THAT(errorFrom(key, "1 ms"),
                HasSubstr("study.x.from must be a number, not \"1 ms\"; study.x.key names no key "
                          "that takes a unit"))
        << key;
  }
}

TEST(StudySection, TakesAnyValueWithALabel) {
  const Scene scene = sceneFrom(
      "[study]\nmeasure = ['error_deg']\nx = { key = 'initial.angular_velocity', "
      "values = [{ label = 'x', value = [4, 0, 0] }, { label = 'y', value = [0, 4, 0] }] }");
  const StudySettings& study = *scene.study;
  EXPECT_THAT(labelsOf(study.x), ElementsAre("x", "y"));
  EXPECT_EQ(scene.runs[1].motion.initial.value, Eigen::Vector3d(0, 4, 0));
  EXPECT_FALSE(study.x.values[0].number.has_value());
}

TEST(StudySection, ReplacesOneSpinByTheOther) {
  const Scene scene = sceneFrom(
      "[study]\nmeasure = ['error_deg']\nx = { key = 'initial.angular_momentum', "
      "values = [{ label = 'x', value = [0.1, 0, 0] }] }");
  EXPECT_EQ(scene.runs[0].motion.initial.kind, physics::SpinKind::AngularMomentum);
}

TEST(StudySection, ReachesIntoTablesArraysAndNudges) {
  const Scene every = sceneFrom(
      "[simulation]\nnormalize = { every = 1 }\n[study]\n"
      "x = { key = 'simulation.normalize.every', values = [1, 50] }\n"
      "measure = ['error_deg']");
  EXPECT_EQ(every.runs[1].motion.simulation.normalizeEvery, 50);
  const Scene nudged = sceneFrom(
      "[[nudge]]\nat = 1\nangular_velocity = [0, 1, 0]\n[study]\n"
      "x = { key = 'nudge.0.at', values = [2, 3.5] }\nmeasure = ['half_turns']");
  EXPECT_EQ(nudged.runs[1].motion.nudges.at(0).at, 3.5);
}

TEST(StudySection, ReadsBackTheSameFromItsText) {
  const Scene scene = sceneFrom(
      "[study]\nmeasure = ['diverges_at', 'stretch']\nx = { key = 'initial.angular_velocity', "
      "values = [{ label = 'x', value = [4.5, 0, 0] }, { label = 'the y', value = [0, 4, 0] }], "
      "label = 'spin' }\n"
      "curves = { key = 'simulation.normalize', values = [true, { label = 'seldom', value = "
      "{ every = 9 } }] }\n"
      "expect = [{ of = 'stretch', x = 'x', curve = 'seldom', max = 2 }]");
  EXPECT_EQ(scene.runs[3].motion.simulation.normalizeEvery, 9);
  EXPECT_EQ(*parseScene(sceneText(scene), "a.toml").study, *scene.study);
}

TEST(StudySection, NamesTheKeyThatIsNone) {
  const auto errorOver = [](const std::string& key) {
    return errorOf("[study]\nx = { key = '" + key + "', values = [1] }\nmeasure = ['error_deg']");
  };
  EXPECT_EQ(errorOver("simulation.substep"),
            "a.toml:2:13: unknown key \"substep\" in [simulation]; did you mean \"substeps\"?");
  EXPECT_MESSAGE(errorOver("simulatio.substeps"));
  EXPECT_MESSAGE(errorOver("clip.fps"));
  EXPECT_MESSAGE(errorOver("body"));
  EXPECT_MESSAGE(errorOver("expect.stretch"));
}

TEST(StudySection, NamesTheValueThatIsWrong) {
  EXPECT_EQ(errorOfStudy("values = [10, 0]"),
            "a.toml:3:50: simulation.substeps must be an integer from 1 to 1000000, not 0");
  EXPECT_EQ(errorOfStudy("values = [10, 10]"), "a.toml:3:50: study.x.values has 10 twice");
  EXPECT_MESSAGE(errorOfStudy("from = 0, to = 9, count = 3, scale = 'log'"));
  EXPECT_MESSAGE(errorOfStudy("from = 1, to = 3, count = 9"));
  EXPECT_MESSAGE(errorOfStudy("from = 1, count = 9"));
  EXPECT_MESSAGE(errorOfStudy("values = [[1, 2]]"));
  EXPECT_MESSAGE(errorOfStudy("values = [{ label = '', value = 1 }]"));
}

TEST(StudySection, RefusesWhatCannotBeMeasuredOrExpected) {
  const auto errorExpecting = [](const std::string& expected) {
    return errorOfStudy("values = [10, 20]", "expect = " + expected);
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

TEST(StudySection, VariesTwoKeys) {
  EXPECT_MESSAGE(
      errorOfStudy("values = [1]", "curves = { key = 'simulation.substeps', values = [1] }"));
}

TEST(StudySection, IsLimited) {
  EXPECT_MESSAGE(errorOfStudy("from = 1, to = 900, count = 900",
                              "curves = { key = 'simulation.normalize', values = [true, false] }"));
  EXPECT_MESSAGE(errorOfStudy("from = 1, to = 1000000, count = 900", "[clip]\nduration = 60"));
}

TEST(StudySection, RefusesAnIntervalInPlaceOfTheOneThatItVaries) {
  EXPECT_EQ(errorOf("[study]\nx = { key = 'simulation.time_per_frame', values = [0.1] }\n"
                    "measure = ['half_turns']\ninterval = 0.01"),
            "a.toml:4:12: study.interval replaces simulation.time_per_frame, which the study "
            "varies; remove one of them");
}

// Where only the start varies, the springs' eigenvalues are solved once.
TEST(StudySection, SettlesTheBodyOnceForAllStarts) {
  const std::string particles =
      "[simulation]\nmodel = 'particles'\nparticles = 'grid:7'\nsubsteps = 300\n";
  const auto runsFrom = [&](const std::string& keyAndValues) {
    const std::string start = "[initial]\nangular_velocity = [4, 0, 0]\ntilt = [0.1, 'z']\n";
    return parseScene(start + particles +
                          "[study]\nmeasure = ['tilt_deg']\nx = { key = " + keyAndValues + " }",
                      "a.toml")
        .runs;
  };
  for (const char* lines :
       {"'initial.tilt.0', values = [0.2, '3 deg', 1]", "'initial.tilt', values = [0.2, 1]",
        "'initial.tilt', values = [{ label = 'y', value = [0.2, 'y'] }, "
        "{ label = 'x', value = ['1 deg', 'z'] }]",
        "'initial.tilt.1', values = ['z', 'y']",
        "'initial.angular_velocity.1', values = [0.2, 1]"}) {
    const std::vector<StudyRun> runs = runsFrom(lines);
    EXPECT_NE(runs[0].motion, runs[1].motion) << lines;
    for (const StudyRun& run : runs)
      EXPECT_EQ(run.motion.particles.system, runs[0].motion.particles.system) << lines;
  }
  const std::vector<StudyRun> masses = runsFrom("'body.mass', values = [1, 2]");
  EXPECT_NE(masses[0].motion.particles.system, masses[1].motion.particles.system);
}

TEST(StudySection, GivesStartsAsIfTheyStoodInTheScene) {
  const std::string start = "[initial]\nangular_velocity = [4, 0, 0]\ntilt = [0.1, 'z']\n";
  const Scene scene = parseScene(
      start +
          "[study]\nmeasure = ['tilt_deg']\nx = { key = 'initial.tilt.0', values = ['3 deg', 1] }",
      "a.toml");
  for (const StudyRun& run : scene.runs) {
    const Scene stated = parseScene(start, "a.toml", std::vector{"initial.tilt.0=" + run.value});
    EXPECT_EQ(run.motion, stated.motions[0]) << run.value;
  }
  EXPECT_MESSAGE(errorOfText(start + "[study]\nmeasure = ['tilt_deg']\n"
                                     "x = { key = 'initial.tilt.0', values = [0.1, 1e7] }"));
  EXPECT_MESSAGE(errorOfText(start + "[study]\nmeasure = ['tilt_deg']\n"
                                     "x = { key = 'initial.angular_velocity', "
                                     "values = [{ label = 'z', value = [0, 0, 4] }] }"));
}

TEST(StudySection, RefusesToVaryWhatNoRunHas) {
  const std::string rest = "', values = [1, 2] }\nmeasure = ['half_turns']";
  EXPECT_EQ(errorOf("[study]\nx = { key = 'simulation.stiffness" + rest),
            "a.toml:2:13: simulation.stiffness is of the model \"particles\" alone; "
            "all runs would be the same");
  EXPECT_EQ(errorOf("[study]\nx = { key = 'simulation.stiffness" + rest +
                    "\ncurves = { key = 'simulation.model', values = ['matrix', 'particles'] }"),
            "no error");
}

TEST(Bounds, HoldWhatLiesWithinThem) {
  EXPECT_TRUE((Bounds{1, 2}.hold(1)));
  EXPECT_TRUE((Bounds{1, 2}.hold(2)));
  EXPECT_FALSE((Bounds{1, 2}.hold(0.999)));
  EXPECT_FALSE((Bounds{1, 2}.hold(2.001)));
  EXPECT_TRUE((Bounds{{}, 2}.hold(-1e300)));
  EXPECT_FALSE(Bounds{}.hold(std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace
}  // namespace rotatebook::scene
