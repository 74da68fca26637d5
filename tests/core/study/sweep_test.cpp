#include "study/sweep.h"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "physics/simulate.h"
#include "scene/scene_text.h"

namespace rotatebook::study {
namespace {

using scene::Quantity;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// Euler's book without normalising, which bursts at once with one step a frame.
scene::Scene bursting(const std::string& more = "") {
  return scene::parseScene(
      "[simulation]\nintegrator = 'euler'\nnormalize = false\n"
      "[initial]\nangular_velocity = [0, 0.1, 6]\n[clip]\nduration = 3\nfps = 30\n"
      "[study]\nover = 'simulation.substeps'\nvalues = [1, 64]\n"
      "measure = ['diverges_at', 'stretch']\n" +
          more,
      "a.toml");
}

SweepStudy resultOf(const scene::Scene& scene) {
  return *runSweep(scene, *scene.study, Execution());
}

TEST(SweepStudy, MeasuresEachRun) {
  const scene::Scene scene = bursting();
  const SweepStudy result = resultOf(scene);
  ASSERT_EQ(result.rows.size(), 2U);
  EXPECT_EQ(result.rows[0].end.kind, RunEnd::Kind::Diverged);
  EXPECT_EQ(result.rows[0].measured[0], result.rows[0].end.time);
  EXPECT_TRUE(std::isnan(result.rows[0].measured[1]));
  EXPECT_TRUE(std::isinf(result.rows[1].measured[0]));
  physics::MotionSettings motion = scene.motion();
  motion.simulation.substeps = 64;
  const physics::Trajectory trajectory = physics::simulate(motion, scene.clip.frameCount());
  EXPECT_EQ(result.rows[1].measured[1], reduced(trajectory, Quantity::Stretch));
  EXPECT_GT(result.rows[1].measured[1], 0.01);  // measured 0.1
}

TEST(SweepStudy, TellsWhichExpectationsAreMet) {
  const scene::Scene scene = bursting(
      "expect = [{ measure = 'diverges_at', at = 1, max = 3 },\n"
      "  { measure = 'diverges_at', at = 64, max = 3 }, { measure = 'stretch', max = 9 }]\n");
  const auto all = expectedOf(resultOf(scene), *scene.study->sweep);
  ASSERT_EQ(all.size(), 4U);
  EXPECT_TRUE(all[0].isMet());
  EXPECT_FALSE(all[1].isMet()) << "it doesn't diverge";
  EXPECT_FALSE(all[2].isMet()) << "the stretch of a motion that diverged isn't known";
  EXPECT_TRUE(all[3].isMet());
  EXPECT_EQ(all[1].subject(), "diverges_at at 64");
}

TEST(SweepStudy, HasATable) {
  const scene::Scene scene =
      bursting("curves = { over = 'simulation.model', values = ['matrix', 'quaternion'] }\n");
  const std::string csv = sweepCsv(resultOf(scene), *scene.study->sweep);
  EXPECT_THAT(csv, StartsWith("simulation.substeps,simulation.model,diverges_at,stretch,status\n"
                              "1,matrix,"));
  EXPECT_THAT(csv, HasSubstr("\n64,quaternion,inf,"));
}

}  // namespace
}  // namespace rotatebook::study
