#include "study/study.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/small_scene.h"
#include "study/study_csv.h"

namespace rotatebook::study {
namespace {

using physics::Integrator;
using scene::testing::messageOf;
using scene::testing::smallScene;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr double kOrderBound = 0.1;       // measured 0.03
constexpr double kRoundingBound = 1e-10;  // of |L| and E in a few hundred steps; measured 1e-14

PrecisionStudy precision(const scene::Scene& scene, const Execution& execution = {}) {
  return runPrecisionStudy(scene, *scene.study, execution).value();
}

/// Makes the runs last to first.
Execution backwards() {
  return {.runAll = [](std::span<const std::size_t> indices, const Run& run) {
    std::for_each(indices.rbegin(), indices.rend(), run);
    return true;
  }};
}

scene::Scene twoIntegrators() {
  return smallScene({"simulation.time_per_frame=0.041666666666666664",
                     "study.integrators=['splitting', 'rk4']", "study.steps=[16, 1, 2, 4, 8]"});
}

scene::Scene tilted(const std::vector<std::string>& overrides = {}) {
  std::vector<std::string> all{"simulation.model=exact", "initial.angular_velocity=[6, 0, 0]",
                               "initial.tilt=[0.1, 'z']", "clip.duration=20",
                               "study.tilts=[0.01, 1e-3, 1e-5]"};
  all.insert(all.end(), overrides.begin(), overrides.end());
  return smallScene(all);
}

TEST(PrecisionStudy, HasARowARunInTheOrderOfTheSettings) {
  const PrecisionStudy study = precision(twoIntegrators());
  ASSERT_EQ(study.rows.size(), 10U);
  EXPECT_EQ(study.rows[0].integrator, Integrator::Splitting);
  EXPECT_EQ(study.rows[0].h, 1.0 / 24 / 16);
  EXPECT_EQ(study.rows[0].steps, 11 * 16);
  EXPECT_EQ(study.rows[1].h, 1.0 / 24);
  EXPECT_EQ(study.rows[6].integrator, Integrator::Rk4);
  EXPECT_EQ(study.rows[6].steps, 11);
  for (const PrecisionRow& row : study.rows) EXPECT_EQ(row.end.text(), "ok");
}

TEST(PrecisionStudy, MeasuresWhatTheTrajectoryShows) {
  const scene::Scene scene = twoIntegrators();
  const PrecisionStudy study = precision(scene);
  const PrecisionRow& row = study.rows[9];  // rk4, 8 steps
  physics::MotionSettings settings = scene.motion();
  settings.simulation.integrator = Integrator::Rk4;
  settings.simulation.substeps = 8;
  const physics::Trajectory motion = simulate(settings, scene.clip.frameCount());
  double largest = 0;
  for (const physics::Sample& sample : motion.samples) largest = std::max(largest, sample.errorDeg);
  EXPECT_EQ(row.errorDeg, largest);
  EXPECT_EQ(row.finalErrorDeg, motion.samples.back().errorDeg);
  EXPECT_EQ(row.halfTurns, motion.samples.back().halfTurns);
  EXPECT_GT(row.energyDrift, 0);
  EXPECT_LT(study.rows[0].momentumDrift, kRoundingBound);
}

TEST(PrecisionStudy, FindsTheOrders) {
  const PrecisionStudy study = precision(twoIntegrators());
  ASSERT_EQ(study.orders.size(), 2U);
  EXPECT_EQ(study.orders[0].integrator, Integrator::Splitting);
  EXPECT_NEAR(study.orders[0].fit.order, 2, kOrderBound);
  EXPECT_NEAR(study.orders[1].fit.order, 4, kOrderBound);
}

TEST(PrecisionStudy, HasATimeOfEachStepThatIsMeasuredForIt) {
  for (const PrecisionRow& row : precision(twoIntegrators()).rows) {
    EXPECT_TRUE(std::isnan(row.nsPerStep));
  }
  const Execution timed{
      .nanosecondsPerStep = [](const physics::MotionSettings& settings, std::int64_t steps) {
        return 1000.0 * static_cast<double>(steps) + settings.simulation.substeps;
      }};
  for (const PrecisionRow& row : precision(twoIntegrators(), timed).rows) {
    EXPECT_EQ(row.nsPerStep,
              1000.0 * static_cast<double>(row.steps) + static_cast<double>(row.steps) / 11);
  }
}

TEST(PrecisionStudy, IsTheSameHoweverTheRunsAreMade) {
  const scene::Scene scene = twoIntegrators();
  EXPECT_EQ(precisionCsv(precision(scene, backwards())), precisionCsv(precision(scene)));
}

TEST(PrecisionStudy, MarksRunsThatDiverge) {
  scene::Scene scene = scene::testing::divergingScene();
  scene.study = {{Integrator::Euler}, {1, 2}};
  const PrecisionStudy study = precision(scene);
  EXPECT_EQ(study.rows[0].end.text(), "diverged at 0.208333 s");
  EXPECT_TRUE(std::isnan(study.rows[0].errorDeg));
  EXPECT_TRUE(std::isnan(study.rows[0].nsPerStep));
  EXPECT_EQ(study.orders[0].fit.runs, 0);
  EXPECT_THAT(precisionCsv(study),
              HasSubstr("\neuler,0.041666666666666664,11,,,,,,,diverged at 0.208333 s\n"));
  EXPECT_THAT(ordersCsv(study), HasSubstr("\neuler,,0,,\n"));
}

TEST(PrecisionStudy, MarksStepsThatHaveNoSolution) {
  const scene::Scene scene = smallScene(
      {"initial.angular_velocity=[50, 30, 10]", "simulation.time_per_frame=0.041666666666666664",
       "study.steps=[1, 64]", "study.integrators=['dmv2', 'rk4']"});
  const PrecisionStudy study = precision(scene);
  EXPECT_EQ(study.rows[0].end.text(), "no convergence");
  EXPECT_EQ(study.rows[1].end.text(), "ok");
  EXPECT_EQ(study.rows[2].end.text(), "ok");
  EXPECT_THAT(precisionCsv(study),
              HasSubstr("\ndmv2,0.041666666666666664,11,,,,,,,no convergence\n"));
}

TEST(PrecisionStudy, MarksStepsOutsideTheReachOfTheirSeries) {
  const scene::Scene scene = smallScene(
      {"simulation.time_per_frame=1", "study.steps=[1, 64]", "study.integrators=['dmv4', 'dmv6']"});
  const PrecisionStudy study = precision(scene);
  for (const std::size_t i : {0U, 2U}) {
    EXPECT_EQ(study.rows[i].end.text(), "step too long for its series");
    EXPECT_EQ(study.rows[i + 1].end.text(), "ok");
  }
  EXPECT_THAT(precisionCsv(study), HasSubstr("\ndmv4,1,11,,,,,,,step too long for its series\n"));
}

TEST(PrecisionStudy, IsNothingAfterAStop) {
  const std::atomic<bool> stop = true;
  const scene::Scene scene = twoIntegrators();
  EXPECT_FALSE(runPrecisionStudy(scene, *scene.study, {.stop = &stop}).has_value());
}

TEST(PrecisionStudy, RefusesWhatHasNothingToVary) {
  const auto refusal = [](const char* setting) {
    return messageOf<InputError>([setting] { requireStudyable(smallScene({setting}), {}); });
  };
  EXPECT_EQ(refusal("simulation.model=exact"),
            "small: the model \"exact\" takes no steps, so there are no steps to compare; "
            "choose another model, e.g. --set simulation.model=quaternion");
  EXPECT_EQ(refusal("clip.duration=0.04"),
            "small: a single sample has no motion to study; make it longer");
}

TEST(PrecisionStudy, TakesTheSameStepsAtAnyInterval) {
  const PrecisionStudy study =
      precision(smallScene({"study.integrators=['rk4']", "study.steps=[4]", "study.duration=1",
                            "study.interval=0.02", "clip.fps=7"}));
  EXPECT_EQ(study.rows[0].h, 1.0 / 60 / 4);
  EXPECT_EQ(study.rows[0].steps, 60 * 4);
}

// Only steps without a solution are a row's end; what is wrong with the scene is the caller's.
TEST(PrecisionStudy, PassesOtherErrorsOn) {
  scene::Scene scene = twoIntegrators();
  scene.study->integrators = {Integrator::Rk4, Integrator::Verlet};
  EXPECT_EQ(messageOf<InputError>([&] { precision(scene); }),
            "this model doesn't have this integrator");
  scene = twoIntegrators();
  scene.initial.value = {1e200, 1e200, 1e200};
  EXPECT_EQ(messageOf<InputError>([&] { precision(scene); }),
            "the motion's start is not finite: its numbers are too large");
}

TEST(PrecisionCsv, HasItsColumns) {
  const PrecisionStudy study = precision(twoIntegrators());
  EXPECT_THAT(precisionCsv(study),
              StartsWith("integrator,h_s,steps,error_deg,final_error_deg,energy_drift,L_drift,"
                         "half_turns,ns_per_step,status\nsplitting,0.0026041666666666665,176,"));
  EXPECT_THAT(ordersCsv(study),
              StartsWith("integrator,order,runs,shortest_h_s,longest_h_s\nsplitting,"));
  EXPECT_THAT(ordersCsv(study), HasSubstr(",5,0.0026041666666666665,0.041666666666666664\n"));
}

// Values of no motion, all different, so that no two columns can change places unnoticed.
TEST(PrecisionCsv, HasEachValueInItsColumn) {
  PrecisionStudy study;
  study.rows = {{.integrator = Integrator::Cf4,
                 .h = 0.25,
                 .steps = 3,
                 .errorDeg = 4.5,
                 .finalErrorDeg = 0.5,
                 .energyDrift = 6e-7,
                 .momentumDrift = 7e-8,
                 .halfTurns = 8,
                 .nsPerStep = 90.1234}};
  study.orders = {{Integrator::Cf4, {.order = 3.75, .runs = 5, .shortest = 0.125, .longest = 2}}};
  EXPECT_EQ(precisionCsv(study),
            "integrator,h_s,steps,error_deg,final_error_deg,energy_drift,L_drift,half_turns,"
            "ns_per_step,status\ncf4,0.25,3,4.5,0.5,6e-07,7e-08,8,90.1,ok\n");
  EXPECT_EQ(ordersCsv(study),
            "integrator,order,runs,shortest_h_s,longest_h_s\ncf4,3.75,5,0.125,2\n");
}

TEST(TiltCsv, HasEachValueInItsColumn) {
  TiltStudy study;
  study.rows = {{.tilt = 0.5, .flips = 2, .interval = 6, .law = 4}};
  EXPECT_EQ(tiltCsv(study), "tilt_rad,flips,interval_s,law_s,ratio,status\n0.5,2,6,4,1.5,ok\n");
}

TEST(TiltStudy, MeasuresTheIntervalOfEachTilt) {
  const scene::Scene scene = tilted();
  const TiltStudy study = runTiltStudy(scene, *scene.study, {}).value();
  ASSERT_EQ(study.rows.size(), 3U);
  for (const TiltRow& row : study.rows) {
    EXPECT_EQ(row.end.text(), "ok");
    EXPECT_GE(row.flips, 2);
    EXPECT_NEAR(row.ratio(), 1, 1e-5);  // measured 6e-6
  }
  EXPECT_EQ(study.rows[1].tilt, 1e-3);
  // A hundredth of the tilt makes the interval longer by as much as a tenth does twice.
  const double once = study.rows[1].interval - study.rows[0].interval;
  EXPECT_NEAR((study.rows[2].interval - study.rows[1].interval) / once, 2, 1e-3);
  EXPECT_NEAR(study.greatestDeviation(), std::fabs(study.rows[0].ratio() - 1), 1e-12);
}

TEST(TiltStudy, IsTheSameHoweverTheRunsAreMade) {
  const scene::Scene scene = tilted();
  const auto table = [&](const Execution& execution) {
    return tiltCsv(runTiltStudy(scene, *scene.study, execution).value());
  };
  EXPECT_EQ(table(backwards()), table({}));
}

TEST(TiltStudy, MarksMotionsThatFlipTooRarely) {
  const scene::Scene scene = tilted({"clip.duration=5"});
  const TiltStudy study = runTiltStudy(scene, *scene.study, {}).value();
  EXPECT_EQ(study.rows[0].end.kind, RunEnd::Kind::Whole);
  EXPECT_EQ(study.rows[2].end.text(), "fewer than two flips in 4.95833 s");
  EXPECT_EQ(study.rows[2].flips, 1);
  EXPECT_TRUE(std::isnan(study.greatestDeviation()));
  EXPECT_THAT(tiltCsv(study), StartsWith("tilt_rad,flips,interval_s,law_s,ratio,status\n0.01,"));
  EXPECT_THAT(tiltCsv(study), HasSubstr("\n1e-05,1,,"));
  EXPECT_THAT(tiltCsv(study), HasSubstr(",,fewer than two flips in 4.95833 s\n"));
}

TEST(TiltStudy, MarksRunsThatDivergeOrHaveNoSolution) {
  const scene::Scene soft =
      tilted({"simulation.model=particles", "simulation.normalize=false", "simulation.substeps=1"});
  EXPECT_THAT(tiltCsv(runTiltStudy(soft, *soft.study, {}).value()), HasSubstr(",,diverged at "));
  const scene::Scene stiff =
      tilted({"simulation.model=quaternion", "simulation.integrator=midpoint",
              "simulation.step=0.0625", "initial.angular_velocity=[90, 0, 0]"});
  EXPECT_THAT(tiltCsv(runTiltStudy(stiff, *stiff.study, {}).value()),
              HasSubstr(",,no convergence\n"));
}

}  // namespace
}  // namespace rotatebook::study
