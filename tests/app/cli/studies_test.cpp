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
  EXPECT_EQ(countOf("\n  met    order of ", result.output), 10);
  EXPECT_EQ(countOf(",ok\n", read("out/figc-work-precision-study.csv")), 10 * 14);
}

TEST_F(ShippedStudy, OfEveryIntegratorFindsNoneOfEulerOnTheFlippingBook) {
  const ChildResult result = study(
      "figc-work-precision", {"initial.angular_velocity=[4, 0, 0]", "initial.tilt=[0.001, 'z']",
                              "study.integrators=['euler', 'rk4']", "clip.duration=20"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.output, HasSubstr("\n  UNMET  order of euler: "));
}

TEST_F(ShippedStudy, OfTheFlipIntervalFindsTheLaw) {
  const ChildResult result = study("figb-flip-interval");
  EXPECT_EQ(result.status, 0) << result.output << result.error;
  EXPECT_EQ(countOf(",ok\n", read("out/figb-flip-interval-study.csv")), 10);
}

TEST_F(ShippedStudy, OfTheFlipIntervalFindsNoLawInEulersMotion) {
  const ChildResult result = study("figb-flip-interval", {"simulation.model=quaternion"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.output, HasSubstr("\n  UNMET  flip_law: "));
}

TEST_F(ShippedStudy, OfTheSpringsEndsWhereTheyStretch) {
  const ChildResult result = study("particles");
  EXPECT_EQ(result.status, 0) << result.output << result.error;
  EXPECT_THAT(result.output, HasSubstr("\n  verlet           no order"));
  EXPECT_THAT(result.output, Not(HasSubstr("found no solution")));
}

}  // namespace
}  // namespace rotatebook::cli::testing
