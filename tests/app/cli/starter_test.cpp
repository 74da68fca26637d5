// scenes/starter.toml, which everybody copies first.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/program_test.h"
#include "physics/simulate.h"
#include "store/scene_file.h"

namespace rotatebook::cli::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

const fs::path kStarter = fs::path(ROTATEBOOK_SOURCE) / "scenes/starter.toml";
constexpr double kErrorBound = 1e-6;  // degrees; measured 1.8e-9

double errorOf(const std::vector<std::string>& overrides) {
  const scene::Scene scene = store::readScene(kStarter, overrides);
  double error = 0;
  for (const physics::Sample& sample :
       physics::simulate(scene.motions[0].motion(), scene.clip.frameCount()).samples) {
    error = std::max(error, sample.errorDeg);
  }
  return error;
}

TEST(Starter, IsTrueToTheExactMotion) {
  EXPECT_LT(errorOf({}), kErrorBound);
  EXPECT_GT(errorOf({"simulation.integrator=euler"}), 90);  // measured 180
}

TEST(Starter, TurnsOver) {
  const scene::Scene scene = store::readScene(kStarter);
  const auto motion = physics::simulate(scene.motions[0].motion(), scene.clip.frameCount());
  EXPECT_GE(motion.samples.back().halfTurns, 3);  // measured 4
}

class EditedStarter : public ProgramTest, public ::testing::WithParamInterface<std::string> {};

TEST_P(EditedStarter, MeetsItsExpectations) {
  const ChildResult result = run({"simulate", kStarter, "--csv", "x.csv", "--set", GetParam()});
  EXPECT_EQ(result.status, 0) << result.output << result.error;
  EXPECT_THAT(result.output, HasSubstr("\n  met      energy_ratio"));
}

INSTANTIATE_TEST_SUITE_P(
    OnOneNumber, EditedStarter,
    ::testing::Values("clip.duration=6", "clip.duration=5 s", "clip.duration=1", "clip.duration=30",
                      "initial.angular_velocity=[0, 5, 0]", "initial.angular_velocity=[8, 0, 0]",
                      "initial.angular_velocity=[1, 2, 3]", "initial.tilt=[0.1, 'y']",
                      "body.size=[0.07, 0.15, 0.008]", "body.mass=0.2", "body.mass=800 g",
                      "initial.angular_velocity=['90 rpm', 0, 0]", "clip.fps=30",
                      "simulation.substeps=20", "simulation.model='matrix'",
                      "simulation.model='particles'", "simulation.model='exact'",
                      "simulation.normalize=false", "simulation.time_per_frame=0.004"));

// They are no empty words.
TEST_F(ProgramTest, StarterByEulerFailsItsExpectations) {
  const ChildResult result =
      run({"simulate", kStarter, "--csv", "x.csv", "--set", "simulation.integrator='euler'"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.output, HasSubstr("; up to 180 degrees from the exact motion; more than 10 "
                                       "from 3.85 s on\n  not met  energy_ratio: "));
}

}  // namespace
}  // namespace rotatebook::cli::testing
