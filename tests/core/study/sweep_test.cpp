#include "study/sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/small_scene.h"

namespace rotatebook::study {
namespace {

using scene::testing::smallScene;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

SweepStudy resultOf(const scene::Scene& scene, const Execution& execution = {}) {
  return runSweep(scene, *scene.study, execution).value();
}

/// Particles with one step a frame, which diverge, and with 4096.
scene::Scene explosions(const std::vector<std::string>& overrides = {}) {
  std::vector<std::string> all{"simulation.model=particles",
                               "simulation.normalize=false",
                               "simulation.time_per_frame=0.041666666666666664",
                               "study.x={key='simulation.substeps', values=[1, 4096]}",
                               "study.curves={key='simulation.damping', values=[0, 1.5]}",
                               "study.measure=['diverges_at', 'stretch']"};
  all.insert(all.end(), overrides.begin(), overrides.end());
  return smallScene(all);
}

TEST(Sweep, MeasuresEveryRunInTheOrderOfTheCurves) {
  const SweepStudy result = resultOf(explosions());
  ASSERT_EQ(result.rows.size(), 4U);
  EXPECT_EQ(result.rows[1].value, "4096");
  EXPECT_EQ(result.rows[1].curve, "0");
  EXPECT_EQ(result.rows[2].curve, "1.5");
  EXPECT_EQ(result.rows[0].end.text(), "diverged at 0.208333 s");
  EXPECT_NEAR(result.rows[0].measured[0], 0.208333, 1e-6);
  EXPECT_TRUE(std::isnan(result.rows[0].measured[1]));
  EXPECT_EQ(result.rows[1].end.text(), "ok");
  EXPECT_EQ(result.rows[1].measured[0], kInfinity);
  EXPECT_GT(result.rows[1].measured[1], 0);
  EXPECT_NEAR(result.rows[1].length, 11 / 24.0, 1e-12);
}

TEST(Sweep, TellsNeverFromUnknownInItsTable) {
  const scene::Scene scene = explosions();
  const std::string csv = sweepCsv(resultOf(scene), *scene.study->sweep);
  EXPECT_THAT(csv,
              testing::StartsWith(
                  "simulation.substeps,simulation.damping,diverges_at,stretch,status\n1,0,0.2"));
  EXPECT_THAT(csv, HasSubstr(",,diverged at 0.208333 s\n4096,0,inf,"));
}

TEST(Sweep, QuotesLabelsThatNeedIt) {
  const scene::Scene scene =
      smallScene({"study.x={key='simulation.substeps', values=["
                  "{label='one, \"rough\"', value=1}, {label='eight', value=8}]}",
                  "study.measure=['half_turns']"});
  const std::string csv = sweepCsv(resultOf(scene), *scene.study->sweep);
  EXPECT_THAT(csv, HasSubstr("\n\"one, \"\"rough\"\"\","));
  EXPECT_THAT(csv, HasSubstr("\neight,"));
}

TEST(Sweep, ReducesQuantitiesToTheLargestDeparture) {
  for (const char* gainsOrLoses : {"euler", "implicit-gyroscopic"}) {
    const scene::Scene scene =
        smallScene({std::string("simulation.integrator=") + gainsOrLoses, "simulation.substeps=1"});
    const physics::Trajectory motion = scene::testing::motionOf(scene);
    double error = 0, energy = 0;
    for (const physics::Sample& sample : motion.samples) {
      error = std::max(error, sample.errorDeg);
      energy = std::max(energy, std::fabs(sample.total() / motion.samples[0].total() - 1));
    }
    ASSERT_GT(energy, 1e-3);
    EXPECT_EQ(reduced(motion, scene::Measure::ErrorDeg), error);
    EXPECT_EQ(reduced(motion, scene::Measure::EnergyRatio), energy);
    EXPECT_EQ(reduced(motion, scene::Measure::HalfTurns), motion.samples.back().halfTurns);
    EXPECT_EQ(reduced(motion, scene::Measure::DivergesAt), kInfinity);
  }
}

TEST(Sweep, IsTheSameHoweverTheRunsAreMade) {
  const scene::Scene scene = explosions();
  const Execution backwards{
      .runAll = [](std::span<const std::size_t> indices, const study::Run& run) {
        std::for_each(indices.rbegin(), indices.rend(), run);
        return true;
      }};
  EXPECT_EQ(sweepCsv(resultOf(scene, backwards), *scene.study->sweep),
            sweepCsv(resultOf(scene), *scene.study->sweep));
}

TEST(Sweep, ComparesRunsWithWhatIsExpected) {
  const scene::Scene scene =
      explosions({"study.expect=[{of='diverges_at', x=1, curve=0, max=0.3}, "
                  "{of='diverges_at', x=4096, min=0.4}, {of='stretch', curve=0, max=1}]"});
  const std::vector<ExpectedOfRun> expected = expectedOf(resultOf(scene), *scene.study->sweep);
  std::vector<std::string> subjects;
  for (const ExpectedOfRun& one : expected) subjects.push_back(one.subject());
  EXPECT_THAT(subjects,
              ElementsAre("diverges_at at 1, 0", "diverges_at at 4096, 0",
                          "diverges_at at 4096, 1.5", "stretch at 1, 0", "stretch at 4096, 0"));
  EXPECT_TRUE(expected[0].isMet());
  EXPECT_TRUE(expected[1].isMet()) << "never is later than any time";
  EXPECT_FALSE(expected[3].isMet()) << "of a run that diverges no stretch is measured";
  EXPECT_TRUE(expected[4].isMet());
}

TEST(Sweep, HasNoResultAfterAStop) {
  const scene::Scene scene = explosions();
  const std::atomic<bool> stop = true;
  EXPECT_FALSE(runSweep(scene, *scene.study, {.stop = &stop}).has_value());
}

TEST(Sweep, HasADurationAndAnIntervalOfItsOwn) {
  const std::vector<std::string> own{"study.x={key='simulation.substeps', values=[10]}",
                                     "study.measure=['half_turns', 'error_deg']",
                                     "study.duration=3", "study.interval='10 ms'"};
  const SweepRow row = resultOf(smallScene(own)).rows.front();
  EXPECT_DOUBLE_EQ(row.length, 3);
  std::vector<std::string> other = own;
  other.insert(other.end(), {"clip.fps=7", "clip.duration=1"});
  EXPECT_EQ(resultOf(smallScene(other)).rows.front().measured, row.measured);
}

TEST(Sweep, MakesMotionsOfOneLengthWhateverTheTimePerFrame) {
  const SweepStudy result =
      resultOf(smallScene({"study.x={key='simulation.time_per_frame', values=[0.01, 0.1, 0.3]}",
                           "study.measure=['half_turns']", "study.duration=1.2"}));
  for (const SweepRow& row : result.rows) EXPECT_DOUBLE_EQ(row.length, 1.2);
}

}  // namespace
}  // namespace rotatebook::study
