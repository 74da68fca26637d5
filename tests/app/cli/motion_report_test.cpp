#include "cli/motion_report.h"

#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace rotatebook::cli {
namespace {

using timeline::MotionSummary;

/// A motion whose largest error is this, and visible from then on. [degrees, s]
std::string distanceOf(double errorDeg, std::optional<double> visibleFrom = {}) {
  return distanceText({.motion = {}, .errorDeg = errorDeg, .visibleFrom = visibleFrom});
}

TEST(DistanceText, BoundsASmallErrorByOneDigit) {
  EXPECT_EQ(distanceOf(1.2e-9), "within 2e-9 degrees of the exact motion");
  EXPECT_EQ(distanceOf(9.1e-14), "within 1e-13 degrees of the exact motion");
  EXPECT_EQ(distanceOf(0.41), "within 0.5 degrees of the exact motion");
  EXPECT_EQ(distanceOf(0.95), "within 1 degree of the exact motion");
  EXPECT_EQ(distanceOf(0), "within 0 degrees of the exact motion");
}

TEST(DistanceText, SaysHowFarAVisibleErrorWent) {
  EXPECT_EQ(distanceOf(3.141), "up to 3.15 degrees from the exact motion");
  EXPECT_EQ(distanceOf(10), "up to 10 degrees from the exact motion");
}

TEST(DistanceText, SaysFromWhenOnAnErrorIsLarge) {
  EXPECT_EQ(distanceOf(179.93, 2),
            "up to 180 degrees from the exact motion; more than 10 from 2 s on");
  EXPECT_EQ(distanceOf(11, 1200.4),
            "up to 11 degrees from the exact motion; more than 10 from 1200 s on");
}

TEST(DistanceText, OfABodyThatLosesEnergyIsToOneThatDoesnt) {
  MotionSummary summary{.motion = {}, .errorDeg = 179.93, .visibleFrom = 2};
  summary.motion.simulation.dissipation = 2e-6;
  EXPECT_EQ(
      distanceText(summary),
      "up to 180 degrees from the exact motion without dissipation; more than 10 from 2 s on");
}

TEST(DistanceText, OfTheExactModelHasNoNumber) {
  EXPECT_EQ(distanceText({}), "the exact motion itself, in closed form");
}

TEST(EnergyText, BoundsASmallChangeAndGivesTheRangeOfALargeOne) {
  MotionSummary summary;
  summary.lowestEnergy = 1 - 2.1e-9;
  summary.highestEnergy = 1 + 1e-9;
  EXPECT_EQ(energyText(summary), "energy kept to 3e-9");
  summary.lowestEnergy = 0.75;
  EXPECT_EQ(energyText(summary), "energy 0.75 to 1 of its start");
}

/// Two panels, the second of which diverges.
std::vector<MotionSummary> exampleMotions() {
  MotionSummary exact, euler;
  exact.motion.label = "Exact \"one\"";
  exact.motion.simulation.model = physics::Model::Exact;
  exact.motion.body.size = {0.1, 20, 0.1};
  exact.flips = {2.25};
  euler.motion.label = "Euler";
  euler.motion.simulation.model = physics::Model::Quaternion;
  euler.motion.simulation.integrator = physics::Integrator::Euler;
  euler.frames = 90;
  for (int n = 1; n <= 9; ++n) euler.flips.push_back(n * 1.5);
  euler.highestEnergy = 2.5;
  euler.errorDeg = 179.96;
  euler.visibleFrom = 0.1 + 0.2;
  euler.divergedAt = 22.53333333333333;
  euler.notes = {"the regime changes"};
  return {exact, euler};
}

TEST(MotionReport, HasALineForEachPanelUnderItsLabel) {
  std::ostringstream out;
  reportMotions(exampleMotions(), out);
  EXPECT_EQ(out.str(),
            "  Exact \"one\":\n"
            "  1 flip, at 2.25 s; energy kept exactly; the exact motion itself, in closed form\n"
            "  Euler:\n"
            "  9 flips, at 1.5, 3, 4.5, 6, 7.5, 9, 10.5, 12 ... s; energy 1 to 2.5 of its start; "
            "up to 180 "
            "degrees from the exact motion; more than 10 from 0.3 s on\n"
            "  the motion diverges at 22.5333 s, after 90 frames\n");
}

TEST(MotionReport, NamesSceneAndPanelInNotes) {
  scene::Scene scene;
  scene.name = "s";
  std::ostringstream out;
  reportNotes(scene, exampleMotions(), out);
  EXPECT_EQ(out.str(), "note: s, Euler: the regime changes\n");
}

TEST(MotionReport, IsJsonToo) {
  EXPECT_EQ(
      jsonText(motionsJson(exampleMotions())),
      R"([{"label":"Exact \"one\"","model":"exact","integrator":null,"half_turns":1,"flips_s":[2.25],)"
      R"("energy_ratio":{"lowest":1.0,"highest":1.0},"error_deg":null,"visible_from_s":null,)"
      R"("diverged_at_s":null,"diverges_unexpectedly":false,"judged":true,"met":true,"expectations":[],"notes":["the body is 20 m )"
      R"(long; numbers without a unit are in metres: a centimetre is \"1 cm\""]},)"
      R"({"label":"Euler","model":"quaternion","integrator":"euler","half_turns":9,)"
      R"("flips_s":[1.5,3.0,4.5,6.0,7.5,9.0,10.5,12.0,13.5],)"
      R"("energy_ratio":{"lowest":1.0,"highest":2.5},"error_deg":179.96,)"
      R"("visible_from_s":0.30000000000000004,"diverged_at_s":22.53333333333333,"diverges_unexpectedly":false,"judged":true,)"
      R"("met":true,)"
      R"("expectations":[],"notes":["the regime changes"]}])");
}

TEST(MotionReport, OfASimulationHasItsTables) {
  scene::Scene scene;
  scene.name = "s";
  scene.title = "back\\slash";
  std::vector<MotionSummary> one{exampleMotions()[1]};
  one[0].notes = {};
  std::ostringstream out;
  reportSimulationAsJson(scene, {{"a/s.csv", one.front().frames}}, one, out);
  EXPECT_EQ(out.str(),
            R"({"name":"s","title":"back\\slash","tables":[{"path":"a/s.csv","rows":90}],)"
            R"("motions":)" +
                jsonText(motionsJson(one)) + "}\n");
}

}  // namespace
}  // namespace rotatebook::cli
