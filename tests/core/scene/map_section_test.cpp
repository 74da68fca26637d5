// [map]: what is read, printed and refused.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "messages.h"
#include "scene/motion_numbers.h"
#include "scene/parse.h"
#include "scene/scene_text.h"

namespace rotatebook::scene {
namespace {

using ::testing::HasSubstr;

constexpr const char* kX =
    "x = { key = 'simulation.substeps', from = 1, to = 100, scale = 'log' }\n";
constexpr const char* kY = "y = { key = 'body.mass', from = 0.5, to = 2 }\n";

std::string withAxes(const std::string& lines) {
  return std::string("[map]\n") + kX + kY + lines;
}

MapSettings mapOf(const std::string& lines) {
  return *sceneFrom(withAxes(lines)).map;
}

/// The message about a map with these lines from the fourth on, and the measure half_turns.
std::string errorOfMap(const std::string& lines) {
  return errorOf(withAxes("measure = 'half_turns'\n" + lines));
}

/// The message about a map whose x is `axis`, in the second line.
std::string errorOfAxis(const std::string& axis, const std::string& before = "") {
  return errorOf("[map]\nx = { " + axis + " }\n" + kY + "measure = 'half_turns'\n" + before);
}

TEST(MapSection, HasAxesAndMeasure) {
  const MapSettings map = mapOf("measure = 'first_flip'\nsize = [20, 10]\nduration = '2 s'");
  EXPECT_EQ(map.x.key, "simulation.substeps");
  EXPECT_EQ(map.x.kind, AxisKind::MotionKey);
  EXPECT_EQ(map.x.scale, Scale::Logarithmic);
  EXPECT_EQ(map.y.to, 2);
  EXPECT_EQ(map.measure, Measure::FirstFlip);
  EXPECT_EQ(map.runs(), 200);
  EXPECT_EQ(map.duration, 2.0);
}

TEST(MapSection, HasAxesWithUnits) {
  const Scene scene = sceneFrom(
      "[map]\nx = { key = 'time', from = '500 ms', to = 2 }\n"
      "y = { key = 'initial.angular_velocity.2', from = 1, to = '60 rpm' }\nmeasure = 'tilt_deg'");
  EXPECT_EQ(scene.map->x.from, 0.5);
  EXPECT_EQ(scene.map->y.to, 2 * std::numbers::pi);
  EXPECT_THAT(sceneText(scene), HasSubstr("{ key = \"time\", from = 0.5, to = 2.0,"));
  EXPECT_EQ(*parseScene(sceneText(scene), "a.toml").map, *scene.map);
  EXPECT_EQ(errorOfAxis("key = 'time', from = '1 s', to = '2 deg'"),
            "a.toml:2:40: map.x.to must be a number, not \"2 deg\"; a text is a number and a unit, "
            "\"s\", \"ms\" or \"min\", such as \"1.5 s\"");
  EXPECT_EQ(errorOfAxis("key = 'time', from = '-1 s', to = 2"),
            "a.toml:2:28: map.x.from must be at least 0.0, not \"-1 s\"");
  EXPECT_EQ(errorOfAxis("key = 'spin.longitude', from = '1 deg', to = 2"),
            "a.toml:2:38: map.x.from must be a number, not \"1 deg\"; map.x.key names no key that "
            "takes a unit");
}

TEST(MapSection, PutsValuesIntoTheMiddlesOfPixels) {
  const MapSettings map = mapOf("measure = 'half_turns'");
  EXPECT_DOUBLE_EQ(map.y.at(0, 3), 0.75);
  EXPECT_DOUBLE_EQ(map.y.at(2, 3), 1.75);
  EXPECT_NEAR(map.x.at(0, 1), 10, 1e-12) << "the middle of a logarithmic axis";
}

TEST(MapSection, IsPrintedAsItIsRead) {
  const Scene scene = sceneFrom(withAxes(
      "measure = 'error_deg'\nmoment = 'largest'\nsize = [30, 20]\nduration = 3\ninterval = 0.1\n"
      "colors = { palette = 'viridis', reversed = true, from = 1, to = 100, scale = 'log', "
      "contours = [2, 5.5] }\n"
      "marks = [{ at = [10, 1], label = 'a \"b\"' }]\n"
      "expect = [{ of = 'share', outcome = 'diverged', max = 0.5 }, "
      "{ of = 'share', over = 3, under = 4, min = 0 }, { of = 'value', at = [10, 1], min = 1 }]"));
  const Scene again = parseScene(sceneText(scene), "a.toml");
  EXPECT_EQ(again.map, scene.map);
  EXPECT_EQ(scene.map->expected.size(), 3U);
  EXPECT_EQ(sceneText(again), sceneText(scene));
}

constexpr const char* kColours = "colors = { from = 0, to = 9 }\n";

TEST(MapFilm, IsPrintedAsItIsRead) {
  const Scene scene =
      sceneFrom(withAxes(std::string("measure = 'half_turns'\n") + kColours +
                         "film = { x = [10, 20], y = [1, 1.5], duration = '2 s' }"));
  EXPECT_EQ(scene.map->film, (MapFilm{{10, 20}, {1, 1.5}, 2}));
  EXPECT_EQ(parseScene(sceneText(scene), "a.toml").map, scene.map);
}

TEST(MapFilm, ZoomsFromTheWholeMapIntoItsPart) {
  const MapSettings map =
      mapOf(std::string("measure = 'half_turns'\n") + kColours +
            "film = { x = [10, 100] }\n"
            "marks = [{ at = [2, 1], label = 'a' }, { at = [50, 1], label = 'b' }]");
  const MapSettings first = mapOfFilm(map, 0), middle = mapOfFilm(map, 0.5),
                    last = mapOfFilm(map, 1);
  EXPECT_FALSE(first.film);
  EXPECT_NEAR(first.x.from, 1, 1e-12);
  EXPECT_NEAR(last.x.from, 10, 1e-11);
  EXPECT_NEAR(last.x.to, 100, 1e-10);
  EXPECT_EQ(last.y, map.y);
  // Half of the decades, then the root of a half.
  EXPECT_NEAR(std::log10(middle.x.to / middle.x.from), 2 * std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(middle.x.to, 100, 1e-10) << "the end at which both end stays";
  EXPECT_EQ(first.marks.size(), 2U);
  ASSERT_EQ(last.marks.size(), 1U);
  EXPECT_EQ(last.marks[0].label, "b");
}

TEST(MapFilm, IsRefusedWhereItCantBe) {
  EXPECT_MESSAGE(errorOfMap("film = { x = [10, 20] }"));
  EXPECT_MESSAGE(errorOfMap(kColours + std::string("film = { duration = 3 }")));
  EXPECT_MESSAGE(errorOfMap(kColours + std::string("film = { x = [20, 10] }")));
  EXPECT_MESSAGE(errorOfMap(kColours + std::string("film = { y = [1, 3] }")));
  EXPECT_MESSAGE(errorOfMap(kColours + std::string("film = { x = [1, 3], duration = 0 }")));
}

TEST(MapSection, TakesNumbersWithinValuesAndSpecialAxes) {
  const Scene scene = sceneFrom(
      "[map]\nx = { key = 'initial.angular_velocity.2', from = 1, to = 2 }\n"
      "y = { key = 'time', from = 0, to = 2 }\nmeasure = 'tilt_deg'");
  EXPECT_EQ(scene.map->timeAxis(), &scene.map->y);
  const MotionNumber number(scene.motions[0].motion(), scene.map->x.key, 1.5, "here");
  physics::MotionSettings motion = scene.motions[0].motion();
  number.set(motion, 1.25);
  EXPECT_EQ(motion.initial.value, Eigen::Vector3d(0, 0, 1.25));
  EXPECT_FALSE(number.isWhole());
}

TEST(MapSection, RoundsWholeNumbers) {
  const Scene scene = sceneFrom("");
  const MotionNumber number(scene.motions[0].motion(), "simulation.substeps", 1, "here");
  physics::MotionSettings motion = scene.motions[0].motion();
  number.set(motion, 6.6);
  EXPECT_EQ(motion.simulation.substeps, 7);
  EXPECT_TRUE(number.isWhole());
}

TEST(MapSection, RefusesKeysThatTakeNoNumber) {
  EXPECT_EQ(errorOfAxis("key = 'simulation.substep', from = 1, to = 2"),
            "a.toml:2:13: there is no key simulation.substep; did you mean \"substeps\"?");
  EXPECT_MESSAGE(errorOfAxis("key = 'simulations.substeps', from = 1, to = 2"));
  EXPECT_MESSAGE(errorOfAxis("key = 'simulation.model', from = 1, to = 2"));
  EXPECT_MESSAGE(errorOfAxis("key = 'initial.tilt.0', from = 1, to = 2"));
  EXPECT_MESSAGE(errorOfAxis("key = 'initial.angular_velocity.3', from = 1, to = 2"));
  EXPECT_MESSAGE(errorOfAxis("key = 'nudge.0.at', from = 1, to = 2"));
  EXPECT_MESSAGE(errorOfAxis("key = 'simulation.stiffness', from = 1, to = 2"));
  EXPECT_MESSAGE(errorOf("[simulation]\nmodel = 'exact'\n" + withAxes("measure = 'half_turns'")));
}

TEST(MapSection, RefusesRangesThatAreNone) {
  EXPECT_EQ(errorOfAxis("key = 'body.mass', from = 2, to = 1"),
            "a.toml:2:33: map.x runs from 2.0 to 1.0; from must be less than to");
  EXPECT_MESSAGE(errorOfAxis("key = 'body.size.0', from = 1, to = 1"));
  EXPECT_EQ(errorOfAxis("key = 'body.size.0', from = 0, to = 1, scale = 'log'"),
            "a.toml:2:35: map.x is logarithmic, which needs from over 0, not 0.0");
  EXPECT_MESSAGE(errorOfAxis("key = 'simulation.substeps', from = 0, to = 9"));
  EXPECT_EQ(errorOfAxis("key = 'body.size.0', from = 1"), "a.toml:2:5: map.x needs to");
  EXPECT_MESSAGE(errorOfAxis("key = 'body.mass', from = 1, to = 2"));
  EXPECT_MESSAGE(errorOfAxis("key = 'spin.latitude', from = -91, to = 2"));
  EXPECT_MESSAGE(errorOfAxis("key = 'moments.middle', from = 0.5, to = 1.5"));
}

TEST(MapSection, RefusesTooManyRuns) {
  EXPECT_MESSAGE(errorOfMap("size = [20000, 10]"));
  EXPECT_EQ(errorOfMap("size = [16384, 16384]"),
            "a.toml:5:8: map.size asks for 268435456 runs; the limit is 100000000, such as "
            "[10000, 10000]");
}

TEST(MapSection, RefusesMeasuresThatTheModelLacks) {
  const std::string exact =
      "[simulation]\nmodel = 'exact'\n[map]\nx = { key = 'body.mass', from = 1, to = 2 }\n"
      "y = { key = 'body.size.0', from = 1, to = 2 }\nmeasure = ";
  EXPECT_EQ(
      errorOf(exact + "'error_deg'"),
      "a.toml:6:11: map.measure = \"error_deg\": the model \"exact\" has no such error; choose "
      "another model, e.g. simulation.model = \"quaternion\"");
  EXPECT_MESSAGE(errorOf(exact + "'centre_drift'"));
  EXPECT_MESSAGE(errorOf(exact + "'half_turn'"));
  EXPECT_MESSAGE(errorOfAxis("key = 'time', from = 0, to = 2", "duration = 3"));
  EXPECT_MESSAGE(errorOf("[map]\nx = { key = 'time', from = 0, to = 2 }\n" + std::string(kY) +
                         "measure = 'first_flip'"));
}

TEST(MapSection, RefusesKeysFromWhichOthersFollow) {
  const std::string map = std::string("[map]\n") + kX + kY + "measure = 'half_turns'\n";
  EXPECT_MESSAGE(errorOf(map + "[body]\nshape = 't-handle'\n"));
  const std::string byMoment =
      "[initial]\nangular_velocity = { about = 'middle', value = 4 }\ntilt = [0.1, 'z']\n";
  EXPECT_MESSAGE(errorOfText(map + byMoment));
  EXPECT_MESSAGE(errorOfText(std::string("[map]\n") + kX +
                             "y = { key = 'initial.angular_velocity.value', from = 1, to = 2 }\n"
                             "measure = 'half_turns'\n" +
                             byMoment));
}

TEST(MapSection, RefusesWhatCantBeMarkedOrExpected) {
  EXPECT_MESSAGE(errorOfMap("marks = [{ at = [1000, 1], label = 'a' }]"));
  EXPECT_MESSAGE(errorOfMap("marks = [{ at = [10, 1] }]"));
  EXPECT_MESSAGE(errorOfMap("marks = [{ label = 'a' }]"));
  EXPECT_MESSAGE(errorOfMap("marks = [{ moments = [1, 2, 3], label = 'a' }]"));
  EXPECT_MESSAGE(errorOfMap("expect = [{ of = 'share', min = 1 }]"));
  EXPECT_MESSAGE(errorOfMap("expect = [{ of = 'value', min = 1 }]"));
  EXPECT_MESSAGE(errorOfMap("expect = [{ of = 'largest' }]"));
  EXPECT_MESSAGE(errorOfMap("expect = [{ of = 'largest', min = 1, panel = 'b' }]"));
  EXPECT_MESSAGE(errorOfMap("colors = { from = 2, to = 1 }"));
  EXPECT_MESSAGE(errorOfMap("colors = { from = 0, scale = 'log' }"));
}

TEST(MapSection, NeedsItsAxesAndAMeasure) {
  EXPECT_EQ(errorOf("[map]\n" + std::string(kX) + kY), "a.toml:1:1: [map] needs measure");
  EXPECT_MESSAGE(errorOf("[map]\n" + std::string(kX) + "measure = 'regime'"));
}

TEST(MapSection, LeavesTheDirectionOfTheSpinToItsAxes) {
  EXPECT_MESSAGE(
      errorOfText("[initial]\nangular_velocity = [5, 0, 0]\ntilt = [0.1, 'z']\n[map]\n"
                  "x = { key = 'spin.longitude', from = 0, to = 90 }\n" +
                  std::string(kY) + "measure = 'half_turns'"));
}

}  // namespace
}  // namespace rotatebook::scene
