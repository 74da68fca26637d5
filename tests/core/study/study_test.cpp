#include "study/study.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/small_scene.h"
#include "study/reduced.h"
#include "study/study_csv.h"

namespace rotatebook::study {
namespace {

using scene::testing::smallScene;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Study resultOf(const scene::Scene& scene, const Execution& execution = {}) {
  return runStudy(scene, execution).value();
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

/// Makes the runs last to first.
Execution backwards() {
  return {.runAll = [](std::span<const std::size_t> indices, const Run& run) {
    std::for_each(indices.rbegin(), indices.rend(), run);
    return true;
  }};
}

/// The steps and the integrators of a study of orders.
std::vector<std::string> ordersOver(const std::string& steps, const std::string& integrators) {
  return {"simulation.time_per_frame=0.041666666666666664",
          "study.x={key='simulation.substeps', values=[" + steps + "]}",
          "study.curves={key='simulation.integrator', values=[" + integrators + "]}"};
}

scene::Scene twoIntegrators() {
  return smallScene(ordersOver("16, 1, 2, 4, 8", "'splitting', 'rk4'"));
}

scene::Scene tilted(const std::vector<std::string>& overrides = {}) {
  std::vector<std::string> all{"simulation.model=exact",
                               "initial.angular_velocity=[6, 0, 0]",
                               "initial.tilt=[0.1, 'z']",
                               "clip.duration=20",
                               "study.x={key='initial.tilt', values=[0.01, 1e-3, 1e-5]}",
                               "study.measure=['flip_interval', 'flip_law', 'first_flip']"};
  all.insert(all.end(), overrides.begin(), overrides.end());
  return smallScene(all);
}

TEST(Study, MeasuresEveryRunInTheOrderOfTheCurves) {
  const Study result = resultOf(explosions());
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

TEST(Study, TellsNeverFromUnknownInItsTable) {
  const scene::Scene scene = explosions();
  const std::string csv = studyCsv(resultOf(scene), *scene.study);
  EXPECT_THAT(csv,
              testing::StartsWith(
                  "simulation.substeps,simulation.damping,diverges_at,stretch,status\n1,0,0.2"));
  EXPECT_THAT(csv, HasSubstr(",,diverged at 0.208333 s\n4096,0,inf,"));
}

TEST(Study, QuotesLabelsThatNeedIt) {
  const scene::Scene scene =
      smallScene({"study.x={key='simulation.substeps', values=["
                  "{label='one, \"rough\"', value=1}, {label='eight', value=8}]}",
                  "study.measure=['half_turns']"});
  const std::string csv = studyCsv(resultOf(scene), *scene.study);
  EXPECT_THAT(csv, HasSubstr("\n\"one, \"\"rough\"\"\","));
  EXPECT_THAT(csv, HasSubstr("\neight,"));
}

TEST(Study, ReducesQuantitiesToTheLargestDeparture) {
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
    EXPECT_EQ(reduced(motion, scene.motions[0].motion(), scene::Measure::ErrorDeg), error);
    EXPECT_EQ(reduced(motion, scene.motions[0].motion(), scene::Measure::EnergyRatio), energy);
    EXPECT_EQ(reduced(motion, scene.motions[0].motion(), scene::Measure::HalfTurns),
              motion.samples.back().halfTurns);
    EXPECT_EQ(reduced(motion, scene.motions[0].motion(), scene::Measure::DivergesAt), kInfinity);
  }
}

TEST(Study, IsTheSameHoweverTheRunsAreMade) {
  const scene::Scene scene = explosions();
  EXPECT_EQ(studyCsv(resultOf(scene, backwards()), *scene.study),
            studyCsv(resultOf(scene), *scene.study));
}

TEST(Study, ComparesRunsWithWhatIsExpected) {
  const scene::Scene scene =
      explosions({"study.expect=[{of='diverges_at', x=1, curve=0, max=0.3}, "
                  "{of='diverges_at', x=4096, min=0.4}, {of='stretch', curve=0, max=1}]"});
  const std::vector<StudyExpectation> expected = expectedOf(resultOf(scene), *scene.study);
  std::vector<std::string> subjects;
  for (const StudyExpectation& one : expected) subjects.push_back(one.subject());
  EXPECT_THAT(subjects,
              ElementsAre("diverges_at at 1, 0", "diverges_at at 4096, 0",
                          "diverges_at at 4096, 1.5", "stretch at 1, 0", "stretch at 4096, 0"));
  EXPECT_TRUE(expected[0].isMet());
  EXPECT_TRUE(expected[1].isMet()) << "never is later than any time";
  EXPECT_FALSE(expected[3].isMet()) << "of a run that diverges no stretch is measured";
  EXPECT_TRUE(expected[4].isMet());
}

TEST(Study, HasNoResultAfterAStop) {
  const scene::Scene scene = explosions();
  const std::atomic<bool> stop = true;
  EXPECT_FALSE(runStudy(scene, {.stop = &stop}).has_value());
}

TEST(Study, HasADurationAndAnIntervalOfItsOwn) {
  const std::vector<std::string> own{"study.x={key='simulation.substeps', values=[10]}",
                                     "study.measure=['half_turns', 'error_deg']",
                                     "study.duration=3", "study.interval='10 ms'"};
  const StudyRow row = resultOf(smallScene(own)).rows.front();
  EXPECT_DOUBLE_EQ(row.length, 3);
  std::vector<std::string> other = own;
  other.insert(other.end(), {"clip.fps=7", "clip.duration=1"});
  EXPECT_EQ(resultOf(smallScene(other)).rows.front().measured, row.measured);
}

TEST(Study, MakesMotionsOfOneLengthWhateverTheTimePerFrame) {
  const Study result =
      resultOf(smallScene({"study.x={key='simulation.time_per_frame', values=[0.01, 0.1, 0.3]}",
                           "study.measure=['half_turns']", "study.duration=1.2"}));
  for (const StudyRow& row : result.rows) EXPECT_DOUBLE_EQ(row.length, 1.2);
}

TEST(StudyOfOrders, HasTheStepAndTheLargestErrorOfEachRun) {
  const scene::Scene scene = twoIntegrators();
  const Study study = resultOf(scene);
  ASSERT_EQ(study.rows.size(), 10U);
  EXPECT_EQ(study.rows[0].curve, "splitting");
  EXPECT_EQ(study.rows[0].step, 1.0 / 24 / 16);
  EXPECT_EQ(study.rows[1].step, 1.0 / 24);
  physics::MotionSettings settings = scene.motions[0].motion();
  settings.simulation.integrator = physics::Integrator::Rk4;
  settings.simulation.substeps = 8;
  const physics::Trajectory motion = simulate(settings, scene.clip.frameCount());
  double largest = 0;
  for (const physics::Sample& sample : motion.samples) largest = std::max(largest, sample.errorDeg);
  EXPECT_EQ(study.rows[9].measured, std::vector{largest});
}

TEST(StudyOfOrders, FindsThem) {
  constexpr double kBound = 0.1;  // measured 0.03
  const Study study = resultOf(twoIntegrators());
  ASSERT_EQ(study.orders.size(), 2U);
  EXPECT_EQ(study.orders[0].curve, "splitting");
  EXPECT_NEAR(study.orders[0].fit.order, 2, kBound);
  EXPECT_NEAR(study.orders[1].fit.order, 4, kBound);
  EXPECT_TRUE(resultOf(tilted()).orders.empty());
}

TEST(StudyOfOrders, HasATimeOfEachStepThatIsMeasuredForIt) {
  for (const StudyRow& row : resultOf(twoIntegrators()).rows)
    EXPECT_TRUE(std::isnan(row.nsPerStep));
  const Execution timed{
      .nanosecondsPerStep = [](const physics::MotionSettings& settings, std::int64_t steps) {
        return 1000.0 * static_cast<double>(steps) + settings.simulation.substeps;
      }};
  for (const StudyRow& row : resultOf(twoIntegrators(), timed).rows)
    EXPECT_EQ(row.nsPerStep, (11 * 1000 + 1) * std::stod(row.value));
  EXPECT_TRUE(std::isnan(resultOf(tilted(), timed).rows[0].nsPerStep));
}

TEST(StudyOfOrders, MarksRunsThatDiverge) {
  const scene::Scene scene =
      explosions({"study.curves={key='simulation.damping', values=[0]}",
                  "study.x={key='simulation.substeps', values=[1, 2]}", "study.measure=['order']"});
  const Study study = resultOf(scene);
  EXPECT_EQ(study.rows[0].end.text(), "diverged at 0.208333 s");
  EXPECT_TRUE(std::isnan(study.rows[0].measured[0]));
  EXPECT_TRUE(std::isnan(study.rows[0].nsPerStep));
  EXPECT_EQ(study.orders[0].fit.runs, 0);
  EXPECT_THAT(studyCsv(study, *scene.study),
              testing::StartsWith("simulation.substeps,simulation.damping,h_s,error_deg,"
                                  "ns_per_step,status\n"
                                  "1,0,0.041666666666666664,,,diverged at 0.208333 s\n"));
}

TEST(StudyOfOrders, MarksStepsThatHaveNoSolution) {
  std::vector<std::string> settings = ordersOver("1, 64", "'dmv2', 'rk4'");
  settings.emplace_back("initial.angular_velocity=[50, 30, 10]");
  const Study study = resultOf(smallScene(settings));
  EXPECT_EQ(study.rows[0].end.text(), "no convergence");
  EXPECT_EQ(study.rows[1].end.text(), "ok");
  EXPECT_EQ(study.rows[2].end.text(), "ok");
}

TEST(StudyOfOrders, MarksStepsOutsideTheReachOfTheirSeries) {
  std::vector<std::string> settings = ordersOver("1, 64", "'dmv4', 'dmv6'");
  settings[0] = "simulation.time_per_frame=1";
  const Study study = resultOf(smallScene(settings));
  for (const std::size_t i : {0U, 2U}) {
    EXPECT_EQ(study.rows[i].end.text(), "step too long for its series");
    EXPECT_EQ(study.rows[i + 1].end.text(), "ok");
  }
}

TEST(StudyOfOrders, TakesTheSameStepsAtAnyInterval) {
  std::vector<std::string> settings = ordersOver("4", "'rk4'");
  settings[0] = "study.duration=1";
  settings.insert(settings.end(), {"study.interval=0.02", "clip.fps=7"});
  EXPECT_EQ(resultOf(smallScene(settings)).rows[0].step, 1.0 / 60 / 4);
}

// Only steps without a solution are a row's end; what is wrong with the scene is the caller's.
TEST(Study, PassesOtherErrorsOn) {
  scene::Scene scene = twoIntegrators();
  scene.runs[3].motion.simulation.integrator = physics::Integrator::Verlet;
  EXPECT_EQ(scene::testing::messageOf<InputError>([&] { resultOf(scene); }),
            "this model doesn't have this integrator");
}

// Values of no motion, all different, so that no two columns can change places unnoticed.
TEST(StudyOfOrders, HasEachValueInItsColumn) {
  scene::StudySettings settings;
  settings.x.key = "simulation.substeps";
  settings.curves.emplace().key = "simulation.integrator";
  settings.measures = {scene::Measure::Order, scene::Measure::HalfTurns};
  const Study study{{{"3", "cf4", {}, 20, 0.25, {4.5, 8}, 90.1234}}};
  EXPECT_EQ(
      studyCsv(study, settings),
      "simulation.substeps,simulation.integrator,h_s,error_deg,ns_per_step,half_turns,status\n"
      "3,cf4,0.25,4.5,90.1,8,ok\n");
}

TEST(StudyOfFlips, MeasuresTheIntervalOfEachTilt) {
  const Study study = resultOf(tilted());
  ASSERT_EQ(study.rows.size(), 3U);
  for (const StudyRow& row : study.rows) {
    EXPECT_EQ(row.end.text(), "ok");
    EXPECT_LT(row.measured[1], 1e-5);  // measured 6e-6
    // Nearly half an interval after the start
    EXPECT_NEAR(row.measured[2] / row.measured[0], 0.5, 0.1);  // measured 0.54 at most
  }
  // A hundredth of the tilt makes the interval longer by as much as a tenth does twice.
  const double once = study.rows[1].measured[0] - study.rows[0].measured[0];
  EXPECT_NEAR((study.rows[2].measured[0] - study.rows[1].measured[0]) / once, 2, 1e-3);
}

TEST(StudyOfFlips, SaysNeverOfMotionsThatFlipTooRarely) {
  const Study study = resultOf(tilted({"clip.duration=2"}));
  EXPECT_EQ(study.rows[2].end.text(), "ok");
  EXPECT_EQ(study.rows[2].measured, (std::vector{kInfinity, kInfinity, kInfinity}));
}

TEST(Study, MeasuresTheGrowthOfTheBodyWhateverItsTilt) {
  const Study study = resultOf(tilted({"study.measure=['growth']"}));
  EXPECT_EQ(study.rows[0].measured, study.rows[2].measured);
  EXPECT_GT(study.rows[0].measured[0], 0.1);
}

}  // namespace
}  // namespace rotatebook::study
