#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/info_report.h"
#include "scene/scene_text.h"

namespace rotatebook::cli {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

scene::Scene sceneWith(const std::string& settings) {
  return scene::parseScene("title = \"T\"\nclip.duration = 2\n" + settings, "s.toml");
}

std::string textOf(const std::string& settings) {
  const scene::Scene scene = sceneWith(settings);
  std::ostringstream out;
  printRows(rowsOn(spinNumbersOf(scene).front()), out);
  return out.str();
}

std::string jsonTextOf(const std::string& settings) {
  return jsonText(jsonOf(rowsOn(spinNumbersOf(sceneWith(settings)).front())));
}

std::vector<std::string> remarksWith(const std::string& settings) {
  return remarksOn(spinNumbersOf(sceneWith(settings)).front());
}

constexpr const char* kTumbling =
    "body.inertia = [3, 2, 4]\ninitial = { angular_velocity = [6, 0, 0], tilt = [0.1, 'z'] }\n";

TEST(SpinReport, HasALineForEachNumber) {
  EXPECT_EQ(textOf(kTumbling),
            "  spin        6 rad/s (0.9549 turns a second), 5.73 degrees from x, the middle axis\n"
            "  stability   unstable: small deviations grow as e^(2.121 t), tenfold in 1.085 s\n"
            "  regime      the angular momentum L circles z, the axis of the largest moment\n"
            "  flips       first at 1.766 s, then every 3.014 s\n"
            "  period      6.027 s, of the angular velocity in the body\n"
            "  turn        1935 degrees about L in a period, 5.604 rad/s\n"
            "  phases      2071 of these by the energy, 2 E T / |L|, less 135.8 by geometry, the "
            "solid angle that L encloses in the body\n"
            "  precession  z goes about L at 6.646 rad/s\n"
            "  separatrix  4.676 degrees away; L^2 / (2 E I2) - 1 is 0.004415\n"
            "  Euler       needs 16 substeps, 0.001042 s each, to keep the regime for 1.983 s\n");
}

TEST(SpinReport, LeavesOutWhatASpinHasnt) {
  const std::string stable = textOf("body.inertia = [3, 2, 4]\ninitial.angular_velocity=[0,6,1]\n");
  EXPECT_THAT(stable, AllOf(HasSubstr("stable: small deviations circle the axis at "),
                            HasSubstr("L circles y, the axis of the smallest moment"),
                            HasSubstr(", and "), Not(HasSubstr("flips"))));
  const std::string sphere = textOf("body.inertia = [3, 3, 3]\ninitial.angular_velocity=[0,6,0]\n");
  EXPECT_EQ(sphere,
            "  spin        6 rad/s (0.9549 turns a second)\n"
            "  all moments are equal: it turns steadily about any axis\n");
}

TEST(SpinReport, RemarksOnSpinsOfAnotherKind) {
  EXPECT_THAT(remarksWith(kTumbling), IsEmpty());
  EXPECT_THAT(remarksWith("initial.angular_velocity = [6, 0, 0]"),
              ElementsAre("the spin is exactly about a principal axis: it turns steadily, as "
                          "nothing starts the tumbling"));
  EXPECT_THAT(remarksWith("initial.angular_velocity = [0, 0, 6]"),
              ElementsAre("the spin is exactly about a principal axis: it turns steadily"));
  EXPECT_THAT(remarksWith("body.inertia = [4, 8, 9]\ninitial.angular_velocity = [3, 7, 4]"),
              ElementsAre(HasSubstr("exactly on the separatrix")));
  EXPECT_THAT(remarksWith("body.size = [1, 1, 2]\ninitial.angular_velocity = [3, 7, 4]"),
              ElementsAre(HasSubstr("two moments are equal")));
  EXPECT_THAT(remarksWith("initial.angular_velocity = [3, 7, 4]\nsimulation.model = 'particles'"),
              ElementsAre(HasSubstr("three times the solid book's")));
  EXPECT_THAT(remarksWith("initial.angular_velocity = [6, 0, 0]\n"
                          "nudge = [{ at = 1.5, angular_velocity = [0, 0, 1] }]"),
              ElementsAre("the spin is exactly about a principal axis: it turns steadily",
                          "the numbers are those before the first nudge, at 1.5 s"));
}

TEST(SpinReport, SaysWhereALossOfEnergyEnds) {
  const std::string loses = "simulation.dissipation = 2e-6\n";
  EXPECT_THAT(
      remarksWith(loses + "body.inertia = [0.5, 0.75, 1]\n"
                          "initial.angular_velocity = [0, 4, 0]\ninitial.tilt=[0.1, 'z']"),
      ElementsAre("the numbers are those at the start; dissipation ends in a spin about z at "
                  "3.012 rad/s, in either sense, with 75.33 % of the energy"));
  EXPECT_THAT(remarksWith(loses + "body.inertia = [0.5, 1, 1]\n"
                                  "initial.angular_momentum = [1, 0, 0]\ninitial.tilt=[0.1, 'z']"),
              ElementsAre(HasSubstr("two moments are equal"),
                          HasSubstr("a spin about an axis of the largest moment at 1 rad/s")));
}

TEST(SpinReport, CallsASpinUnstableThatALossOfEnergyDrivesOffItsAxis) {
  const std::string loses =
      "simulation.dissipation = 2e-6\nbody.inertia = [0.5, 0.75, 1]\n"
      "initial.tilt = [0.01, 'y']\ninitial.angular_velocity = ";
  EXPECT_THAT(textOf(loses + "[4, 0, 0]"),
              HasSubstr("unstable by its dissipation: small deviations"));
  EXPECT_THAT(textOf(loses + "[0, 0, 4]"), HasSubstr("  stable: small deviations"));
}

TEST(SpinReport, SaysHowManyStepsArentEnough) {
  SpinNumbers numbers = spinNumbersOf(sceneWith(kTumbling)).front();
  numbers.euler = timeline::EulerSteps{.substeps = {}, .tried = 64, .step = 1e-4};
  std::ostringstream out;
  printRows(rowsOn(numbers), out);
  EXPECT_THAT(out.str(), HasSubstr("needs more than 64 substeps, shorter than 0.0001 s each"));
}

TEST(SpinReport, OfJsonHasAllMembers) {
  EXPECT_THAT(
      jsonTextOf(kTumbling),
      AllOf(
          HasSubstr(
              R"({"label":null,"model":"quaternion","moments_kg_m2":[2.0,3.0,4.0],"axes":[[0.0,1.0,0.0],)"),
          HasSubstr(R"("equal_moments":"none")"), HasSubstr(R"("spun_axis":"middle",)"),
          HasSubstr(R"("steady":false,"regime":1,"growth_per_s":2.1213)"),
          HasSubstr(R"("oscillation_rad_per_s":null,"first_flip_s":1.766)"),
          HasSubstr(R"("euler":{"substeps":16,"tried":16,"h_s":)"), HasSubstr(R"("remarks":[]})")));
  EXPECT_THAT(jsonTextOf("initial.angular_velocity = [6, 0, 0]"),
              AllOf(HasSubstr(R"("steady":true,"regime":0,)"),
                    HasSubstr(R"("period_s":null,"turn_rad":null,"dynamic_turn_rad":null,)"),
                    HasSubstr(R"("margin":0.0,"to_separatrix_rad":0.0,"euler":null,)")));
}

}  // namespace
}  // namespace rotatebook::cli
