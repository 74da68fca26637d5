// The studies that come with the program: each finds what it must, and its twin doesn't.
#include <filesystem>
#include <string>
#include <vector>

#include "cli/program_test.h"

namespace rotatebook::cli::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

const fs::path kStudies = fs::path(ROTATEBOOK_SOURCE) / "scenes/studies";

class ShippedStudy : public ProgramTest {
 protected:
  ChildResult study(const std::string& name, const std::vector<std::string>& overrides = {}) const {
    std::vector<std::string> arguments{"study", (kStudies / (name + ".toml")).string()};
    for (const std::string& change : overrides) {
      arguments.insert(arguments.end(), {"--set", change});
    }
    return run(arguments);
  }
};

TEST_F(ShippedStudy, OfEveryIntegratorFindsItsOrder) {
  const ChildResult result = study("figc-work-precision");
  EXPECT_EQ(result.status, 0) << result.output << result.error;
  EXPECT_EQ(countOf("\n  met      order of ", result.output), 10);
  EXPECT_EQ(countOf(",ok\n", read("out/figc-work-precision-study.csv")), 10 * 14);
}

TEST_F(ShippedStudy, OfEveryIntegratorFindsNoneOfEulerOnTheFlippingBook) {
  const ChildResult result = study(
      "figc-work-precision", {"initial.angular_velocity=[4, 0, 0]", "initial.tilt=[0.001, 'z']",
                              "study.curves.values=['euler', 'rk4']", "clip.duration=20",
                              "study.expect=[{ of = 'order', curve = 'euler', min = 0.95 }]"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.output, HasSubstr("\n  not met  order of euler: "));
}

TEST_F(ShippedStudy, OfTheFlipIntervalFindsTheLaw) {
  const ChildResult result = study("figb-flip-interval");
  EXPECT_EQ(result.status, 0) << result.output << result.error;
  EXPECT_EQ(countOf(",ok\n", read("out/figb-flip-interval-study.csv")), 10);
}

TEST_F(ShippedStudy, OfTheFlipIntervalFindsNoLawInEulersMotion) {
  const ChildResult result = study("figb-flip-interval", {"simulation.model=quaternion"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.output, HasSubstr("\n  not met  flip_law at "));
}

TEST_F(ShippedStudy, OfTheSpringsEndsWhereTheyStretch) {
  const ChildResult result = study("particles");
  EXPECT_EQ(result.status, 0) << result.output << result.error;
  EXPECT_THAT(result.output, HasSubstr("\n  verlet           no order"));
  EXPECT_THAT(result.output, Not(HasSubstr("found no solution")));
}

/// A study, and a change without which it doesn't find what it expects.
struct SweepTwin {
  const char* name;
  const char* change;
};

void PrintTo(const SweepTwin& twin, std::ostream* stream) {
  *stream << twin.name;
}

class ShippedSweep : public ShippedStudy, public ::testing::WithParamInterface<SweepTwin> {};

TEST_P(ShippedSweep, FindsWhatItExpectsAndItsTwinDoesNot) {
  const ChildResult result = study(GetParam().name);
  EXPECT_EQ(result.status, 0) << result.output << result.error;
  EXPECT_THAT(result.output, HasSubstr("\n  met      "));
  const ChildResult twin = study(GetParam().name, {GetParam().change});
  EXPECT_EQ(twin.status, 1) << twin.output << twin.error;
  EXPECT_THAT(twin.output, HasSubstr("\n  not met  "));
}

INSTANTIATE_TEST_SUITE_P(
    All, ShippedSweep,
    ::testing::Values(SweepTwin{"figd-substeps", "simulation.normalize=true"},
                      SweepTwin{"fige-stiffness", "simulation.damping=1"},
                      SweepTwin{"fige2-stretch", "initial.angular_velocity=[0.2, 0.3, -0.4]"},
                      SweepTwin{"figf-matrix-quaternion", "simulation.normalize=true"},
                      SweepTwin{"figg-normalizing", "simulation.substeps=512"},
                      SweepTwin{"figg2-normalizing-steps", "simulation.integrator='rk4'"}));

}  // namespace
}  // namespace rotatebook::cli::testing
