#include "cli/study_execution.h"

#include <string>

#include <gtest/gtest.h>

#include "scene/small_scene.h"
#include "study/study_csv.h"

namespace rotatebook::cli {
namespace {

scene::Scene twoIntegrators() {
  return scene::testing::smallScene(
      {"study.curves={key='simulation.integrator', values=['splitting', 'rk4']}",
       "study.x={key='simulation.substeps', values=[16, 1, 2, 4, 8]}"});
}

study::Study made(int threads) {
  const scene::Scene scene = twoIntegrators();
  return runStudy(scene, onThisMachine({threads})).value();
}

/// The table without the one column that is measured.
std::string withoutTimes(study::Study study) {
  for (study::StudyRow& row : study.rows) row.nsPerStep = 0;
  return studyCsv(study, *twoIntegrators().study);
}

TEST(StudyExecution, GivesTheSameTableWhateverTheNumberOfThreads) {
  const std::string one = withoutTimes(made(1));
  EXPECT_EQ(withoutTimes(made(2)), one);
  EXPECT_EQ(withoutTimes(made(7)), one);
}

TEST(StudyExecution, MeasuresEachStep) {
  for (const study::StudyRow& row : made(1).rows) {
    EXPECT_GT(row.nsPerStep, 1) << row.value;       // measured 20 to 60
    EXPECT_LT(row.nsPerStep, 50'000) << row.value;  // with sanitizers, too
  }
}

TEST(StudyExecution, MakesNoMoreRunsAfterAStop) {
  const std::atomic<bool> stop = true;
  const scene::Scene scene = twoIntegrators();
  EXPECT_FALSE(runStudy(scene, onThisMachine({.stop = &stop})).has_value());
}

}  // namespace
}  // namespace rotatebook::cli
