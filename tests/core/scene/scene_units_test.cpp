// Values with units, as scenes have them beside plain numbers in SI units.
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/units.h"
#include "messages.h"
#include "scene/parse.h"

namespace rotatebook::scene {
namespace {

using ::testing::HasSubstr;

std::string errorOfTilt(const std::string& angle) {
  return errorOfText("[initial]\nangular_velocity = [0, 0, 6]\ntilt = ['" + angle + "', 'x']");
}

TEST(SceneUnits, AreReadByTheKeysOfEachDimension) {
  const Scene scene = parseScene(
      "body = { size = ['18.8 cm', 0.24, '30 mm'], mass = '800 g' }\n"
      "simulation.time_per_frame = '4 ms'\n"
      "initial = { angular_velocity = ['60 rpm', '-0.5 turn/s', 1], tilt = ['0.25 turn', 'z'] }\n"
      "clip = { duration = '0.1 min', poster = '250 ms' }\n"
      "camera = { position = [0, 0, '120 cm'], target = ['1 in', 0, 0] }\n"
      "expect.tilt_deg = { max = 180, from = '500 ms', to = '2 s' }\n",
      "a.toml");
  EXPECT_EQ(scene.motions[0].body.size, Eigen::Vector3d(0.188, 0.24, 0.03));
  EXPECT_EQ(scene.motions[0].body.mass, 0.8);
  EXPECT_EQ(scene.timePerFrame(), 0.004);
  EXPECT_EQ(scene.motions[0].initial.value,
            Eigen::Vector3d(2 * std::numbers::pi, -std::numbers::pi, 1));
  EXPECT_EQ(scene.motions[0].initial.tilt->angle, std::numbers::pi / 2);
  EXPECT_EQ(scene.clip.duration, 6);
  EXPECT_EQ(scene.clip.poster, 0.25);
  EXPECT_EQ(scene.cameraPosition, Eigen::Vector3d(0, 0, 1.2));
  EXPECT_EQ(scene.camera.target, Eigen::Vector3d(0.0254, 0, 0));
  EXPECT_EQ(scene.motions[0].expectations.front().from, 0.5);
  EXPECT_EQ(scene.motions[0].expectations.front().to, 2);
}

TEST(SceneUnits, AreReadFromOverrides) {
  EXPECT_EQ(sceneFrom("", {"body.mass=1200 g"}).motions[0].body.mass, 1.2);
  EXPECT_EQ(sceneFrom("", {"clip.duration='2 s'"}).clip.duration, 2);
  EXPECT_EQ(sceneFrom("", {"body.size=['2 in', 0.1, 0.2]"}).motions[0].body.size.x(), 0.0508);
}

TEST(SceneUnits, AreReportedIfTheyAreOfAnotherDimension) {
  const std::string a = "; a text is a number and a unit, ";
  EXPECT_EQ(errorOf("[body]\nmass = '3 cm'"),
            "a.toml:2:8: body.mass must be a mass from 1e-9 to 1e9 kg, not \"3 cm\"" + a +
                "\"kg\" or \"g\", such as \"1.5 kg\"");
  EXPECT_EQ(errorOf("[body]\nsize = [1, '2 kg', 3]"),
            "a.toml:2:12: body.size must be three lengths from 1e-6 to 1e6 m, not \"2 kg\"" + a +
                "\"m\", \"cm\", \"mm\", \"km\" or \"in\", such as \"1.5 m\"");
  EXPECT_EQ(errorOf("clip.duration = '3 h'"),
            "a.toml:1:17: clip.duration must be a time over 0 s, not \"3 h\"" + a +
                "\"s\", \"ms\" or \"min\", such as \"1.5 s\"");
  EXPECT_EQ(errorOfText("[initial]\nangular_velocity = ['60 rpm', '1 deg', 0]"),
            "a.toml:2:31: initial.angular_velocity must be three numbers from -1e9 to 1e9, at "
            "least one other than 0, not \"1 deg\"" +
                a + "\"rad/s\", \"deg/s\", \"°/s\", \"turn/s\" or \"rpm\", such as \"1.5 rad/s\"");
  EXPECT_MESSAGE(errorOfTilt("1 m"));
}

// A grad is a right angle's hundredth, no radian; a milligram no gram.
TEST(SceneUnits, ThatArentReadAreNotTakenForOthers) {
  EXPECT_EQ(
      errorOfText("[initial]\nangular_velocity = [0, 0, 6]\ntilt = ['1 grad', 'x']"),
      "a.toml:3:9: initial.tilt must be an angle from -1e6 to 1e6 rad, not \"1 grad\"; a text "
      "is a number and a unit, \"rad\", \"deg\", \"turn\" or \"°\", such as \"1.5 rad\"");
  for (const char* text : {"body.mass = '3 mg'", "clip.duration = '3 us'", "body.size = ['1 um']"})
    EXPECT_MESSAGE(errorOf(text)) << text;
  for (const char* tilt : {"1 mrad", "1 gon"}) EXPECT_MESSAGE(errorOfTilt(tilt)) << tilt;
  EXPECT_MESSAGE(errorOfTilt("1 radd"));
  EXPECT_MESSAGE(errorOfText("initial.angular_velocity = '48 rad/min'"));
}

TEST(SceneUnits, KeepTheRangeOfTheKey) {
  EXPECT_EQ(errorOf("body.mass = '0 g'"),
            "a.toml:1:13: body.mass must be a mass from 1e-9 to 1e9 kg, not \"0 g\"");
  EXPECT_EQ(errorOf("body.size = ['0.0001 mm', 1, 1]"),
            "a.toml:1:14: body.size must be three lengths from 1e-6 to 1e6 m, not \"0.0001 mm\"");
}

TEST(SceneUnits, AreRefusedWhereNumbersHaveNone) {
  EXPECT_EQ(errorOf("simulation.stiffness = '5 cm'"),
            "a.toml:1:24: simulation.stiffness must be a positive number, not \"5 cm\"");
  EXPECT_EQ(errorOfText("initial.angular_momentum = ['1 rpm', 0, 0]"),
            "a.toml:1:29: initial.angular_momentum must be three numbers from -1e9 to 1e9, at "
            "least one other than 0, not \"1 rpm\"");
}

TEST(SceneUnits, AreDocumented) {
  std::ifstream stream(std::string(ROTATEBOOK_SOURCE) + "/docs/scene.md");
  std::ostringstream page;
  page << stream.rdbuf();
  for (const Dimension dimension : {Dimension::Length, Dimension::Mass, Dimension::Time,
                                    Dimension::Angle, Dimension::AngularVelocity}) {
    std::string units;
    for (const std::string_view unit : unitsOf(dimension)) {
      units += (units.empty() ? "`" : ", `") + std::string(unit) + "`";
    }
    EXPECT_THAT(page.str(), HasSubstr(" | " + units + " |"));
  }
}

}  // namespace
}  // namespace rotatebook::scene
