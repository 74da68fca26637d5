#include "diagnose/study_execution.h"

#include <string>

#include <gtest/gtest.h>

#include "scene/small_scene.h"
#include "study/study_csv.h"

namespace rotatebook::diagnose {
namespace {

scene::Scene twoIntegrators() {
  return scene::testing::smallScene(
      {"study.integrators=['splitting', 'rk4']", "study.steps=[16, 1, 2, 4, 8]"});
}

study::PrecisionStudy precision(int threads) {
  const scene::Scene scene = twoIntegrators();
  return runPrecisionStudy(scene, *scene.study, onThisMachine({threads})).value();
}

/// The table without the one column that is measured.
std::string withoutTimes(study::PrecisionStudy study) {
  for (study::PrecisionRow& row : study.rows) row.nsPerStep = 0;
  return precisionCsv(study) + ordersCsv(study);
}

TEST(StudyExecution, GivesTheSameTableWhateverTheNumberOfThreads) {
  const std::string one = withoutTimes(precision(1));
  EXPECT_EQ(withoutTimes(precision(2)), one);
  EXPECT_EQ(withoutTimes(precision(7)), one);
}

TEST(StudyExecution, MeasuresEachStep) {
  for (const study::PrecisionRow& row : precision(1).rows) {
    EXPECT_GT(row.nsPerStep, 1) << row.steps;       // measured 20 to 60
    EXPECT_LT(row.nsPerStep, 50'000) << row.steps;  // with sanitizers, too
  }
}

TEST(StudyExecution, MakesNoMoreRunsAfterAStop) {
  const std::atomic<bool> stop = true;
  const scene::Scene scene = twoIntegrators();
  EXPECT_FALSE(runPrecisionStudy(scene, *scene.study, onThisMachine({.stop = &stop})).has_value());
}

}  // namespace
}  // namespace rotatebook::diagnose
