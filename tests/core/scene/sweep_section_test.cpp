#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/parse.h"
#include "scene/scene_text.h"

namespace rotatebook::scene {
namespace {

using ::testing::ElementsAre;

const std::string kSpin = "[initial]\nangular_velocity = [0, 0, 6]\n";

Sweep sweepFrom(const std::string& study) {
  return *parseScene(kSpin + "[study]\n" + study, "a.toml").study->sweep;
}

std::string problemIn(const std::string& study) {
  try {
    parseScene("[study]\n" + study + kSpin, "a.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::vector<int> substepsOf(const Sweep& sweep) {
  std::vector<int> steps;
  for (const SweepRun& run : sweep.runs) steps.push_back(run.motion.simulation.substeps);
  return steps;
}

const std::string kMeasure = "measure = ['diverges_at']\n";

TEST(Sweep, HasARunForEachValue) {
  const Sweep sweep = sweepFrom("over = 'simulation.substeps'\nvalues = [10, 30]\n" + kMeasure);
  EXPECT_THAT(substepsOf(sweep), ElementsAre(10, 30));
  EXPECT_EQ(sweep.runs[1].value, "30");
  EXPECT_EQ(sweep.runs[1].motion.initial.value, Eigen::Vector3d(0, 0, 6));
  EXPECT_THAT(sweep.measures, ElementsAre(Quantity::DivergesAt));
}

TEST(Sweep, TakesRangesOfNumbers) {
  const std::string over = "over = 'simulation.substeps'\n" + kMeasure;
  EXPECT_THAT(substepsOf(sweepFrom(over + "values = { from = 1, to = 7, count = 4 }\n")),
              ElementsAre(1, 3, 5, 7));
  EXPECT_THAT(substepsOf(sweepFrom(over + "values = { from = 1, to = 1000, count = 4, spacing = "
                                          "'logarithmic' }\n")),
              ElementsAre(1, 10, 100, 1000));
}

TEST(Sweep, HasACurveForEachValueOfASecondKey) {
  const Sweep sweep =
      sweepFrom("over = 'simulation.normalize.every'\nvalues = [1, 8]\n" + kMeasure +
                "curves = { over = 'simulation.model', values = ['matrix', 'quaternion'] }\n");
  ASSERT_EQ(sweep.runs.size(), 4U);
  EXPECT_EQ(sweep.runs[1].curve, "matrix");
  EXPECT_EQ(sweep.runs[1].motion.simulation.normalizeEvery, 8);
  EXPECT_EQ(sweep.runs[2].motion.simulation.model, physics::Model::Quaternion);
}

TEST(Sweep, TakesValuesWithLabels) {
  const Sweep sweep = sweepFrom(
      "over = 'initial.angular_momentum'\n"
      "values = [{ label = 'x', value = [1, 0, 0] }, { label = 'y', value = [0, 1, 0] }]\n" +
      kMeasure);
  EXPECT_EQ(sweep.runs[1].value, "y");
  EXPECT_EQ(sweep.runs[1].motion.initial.kind, physics::SpinKind::AngularMomentum);
  EXPECT_EQ(sweep.runs[1].motion.initial.value, Eigen::Vector3d(0, 1, 0));
}

TEST(Sweep, IsPrintedSoThatItIsReadAgain) {
  const Scene scene = parseScene(
      kSpin + "[study]\nover = 'simulation.substeps'\nvalues = { from = 1, to = 9, count = 3 }\n" +
          "measure = ['stretch', 'error_deg']\n"
          "curves = { over = 'body.mass', values = [1, 2.5] }\n"
          "expect = [{ measure = 'stretch', at = 5, curve = '2.5', max = 0.1 }]\n",
      "a.toml");
  EXPECT_EQ(parseScene(sceneText(scene), "a.toml").study, scene.study);
}

TEST(Sweep, IsRefusedWithThePlaceOfTheMistake) {
  EXPECT_EQ(problemIn("over = 'clip.fps'\nvalues = [1]\n" + kMeasure),
            "a.toml:2:8: study.over must be a key of \"body\", \"simulation\", \"initial\" or "
            "\"nudge\", such as \"simulation.substeps\", not \"clip.fps\"");
  EXPECT_EQ(problemIn("over = 'simulation.substeps'\nvalues = [0]\n" + kMeasure),
            "a.toml:3:11: simulation.substeps must be an integer from 1 to 1000000, not 0");
  EXPECT_EQ(problemIn("over = 'simulation.substep'\nvalues = [1]\n" + kMeasure),
            "a.toml:2:8: unknown key \"substep\" in [simulation]; did you mean \"substeps\"?");
  EXPECT_EQ(problemIn("over = 'simulation.substeps'\nvalues = [1, 1]\n" + kMeasure),
            "a.toml:3:14: study.values has 1 twice");
  EXPECT_EQ(problemIn("over = 'simulation.substeps'\nvalues = [1]\n"),
            "a.toml:1:1: [study] has over, so it needs measure");
  EXPECT_EQ(problemIn("over = 'simulation.substeps'\nvalues = [1]\nsteps = [1]\n" + kMeasure),
            "a.toml:4:9: [study] has both over and steps; it varies either that key, or "
            "integrators and steps, or tilts");
  EXPECT_EQ(problemIn("values = [1]\n"), "a.toml:2:10: study.values needs study.over");
  EXPECT_EQ(problemIn("over = 'simulation.substeps'\nvalues = [1]\n" + kMeasure +
                      "expect = [{ measure = 'stretch', max = 1 }]\n"),
            "a.toml:5:23: stretch isn't in study.measure");
}

}  // namespace
}  // namespace rotatebook::scene
