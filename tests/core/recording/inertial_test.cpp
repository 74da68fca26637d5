// Tables with a gyroscope and an accelerometer, each with times of its own.
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "messages.h"
#include "recording/read_recording.h"
#include "recording/refusal.h"

namespace rotatebook::recording {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kBoth =
    "t (s),wx (rad/s),wy (rad/s),wz (rad/s),ax (m/s^2),ay (m/s^2),az (m/s^2)\n";
constexpr const char* kRateHeader = "t (s),wx (rad/s),wy (rad/s),wz (rad/s)\n";

InertialRecording inertial(const std::string& text) {
  return readInertial(text, "m.csv", {});
}

std::string inertialRefusal(const std::string& text) {
  return refusalOf([&] { inertial(text); });
}

TEST(Inertial, DropsRowsWithoutReadingsAtTheEnds) {
  const std::string text = std::string(kBoth) +
                           ",,,,,,\n1,0,0,2,0,0,9\n2,0,0,3,0,0,9\n3,NaN,NaN,NaN,0,0,9\n"
                           "4,NaN,NaN,NaN,NaN,NaN,NaN\n";
  const InertialRecording recording = inertial(text);
  EXPECT_EQ(recording.readings.size(), 2U);
  EXPECT_THAT(recording.notes,
              ElementsAre("3 rows at the table's ends have no reading and are left out"));
  const RecordedMotion motion = readRecording(text, "m.csv", {});
  EXPECT_EQ(motion.duration(), 1);
  EXPECT_THAT(motion.notes(),
              ElementsAre("3 rows at the table's ends have no reading and are left out"));
}

TEST(Inertial, NamesTheRowThatLacksAReadingInTheMiddle) {
  EXPECT_EQ(inertialRefusal(std::string(kRateHeader) + "1,0,0,2\n2,NaN,0,2\n3,0,0,2\n"),
            "m.csv:3: the column \"wx (rad/s)\" has \"NaN\", which is no finite number; leave such "
            "rows out");
  EXPECT_MESSAGE(
      inertialRefusal(std::string(kBoth) + "1,0,0,2,0,0,9\n2,0,0,2,,0,9\n3,0,0,2,0,0,9\n"));
  EXPECT_MESSAGE(inertialRefusal(std::string(kRateHeader) + "1,NaN,NaN,NaN\n2,NaN,NaN,NaN\n"));
}

TEST(Inertial, TakesTwoClocksOfAMergedTable) {
  const InertialRecording recording = inertial(
      std::string(kBoth) + "1,0,0,2,,,\n1.25,,,,0,0,4\n2,0,0,2,,,\n2.25,,,,0,0,8\n3,0,0,2,,,\n");
  ASSERT_EQ(recording.readings.size(), 3U);
  EXPECT_TRUE(recording.notes.empty());
  EXPECT_TRUE(std::isinf(recording.readings[0].force.norm()));  // before the first
  EXPECT_NEAR(recording.readings[1].force.z(), 7, 1e-12);
  EXPECT_MESSAGE(
      inertialRefusal(std::string(kBoth) + "1,0,0,2,,,\n1.5,,,,0,0,4\n1.7,,,,,,\n2,0,0,2,,,\n"));
}

TEST(Inertial, TakesASecondTableWithItsOwnTimes) {
  const std::string rates = std::string(kRateHeader) + "1,0,0,2\n2,0,0,2\n3,0,0,2\n";
  const auto with = [&](const std::string& text) {
    const NamedTable table{text, "a.csv"};
    return readInertial(rates, "m.csv", {.columns = {{"ax", "ax (g)"}}}, &table);
  };
  const InertialRecording recording =
      with("t (ms),ax (g),ay (g),az (g)\n500,0,0,1\n1500,0,0,1\n2500,0,0,2\n");
  EXPECT_NEAR(recording.readings[0].force.z(), 9.80665, 1e-12);
  EXPECT_NEAR(recording.readings[1].force.z(), 1.5 * 9.80665, 1e-12);
  EXPECT_MESSAGE(refusalOf([&] { with("t (s),ax (g),ay (g),az (g)\n50,0,0,1\n51,0,0,1\n"); }));
  EXPECT_MESSAGE(refusalOf([&] { with("t (s),bx,by,bz\n1,0,0,1\n2,0,0,1\n"); }));
}

TEST(Inertial, ReadsUnitsOfAccelerations) {
  const auto forceIn = [](const std::string& unit, const std::string& value) {
    const std::string row = ",0,0,2,0,0," + value + "\n";
    return inertial("t (s),wx (rad/s),wy (rad/s),wz (rad/s),ax" + unit + ",ay" + unit + ",az" +
                    unit + "\n1" + row + "2" + row)
        .readings.front()
        .force.z();
  };
  EXPECT_EQ(forceIn(" (m/s^2)", "9"), 9);
  EXPECT_EQ(forceIn(" (m/s\xC2\xB2)", "9"), 9);
  EXPECT_EQ(forceIn("", "9.8"), 9.8);
  EXPECT_EQ(forceIn(" (g)", "2"), 2 * 9.80665);
  EXPECT_EQ(forceIn("_g", "2"), 2 * 9.80665);
  EXPECT_NEAR(forceIn(" [mg]", "1000"), 9.80665, 1e-12);
  EXPECT_MESSAGE(refusalOf([&] { forceIn(" (counts)", "9"); }));
  EXPECT_MESSAGE(refusalOf([&] { forceIn("", "1.02"); }));
  EXPECT_MESSAGE(refusalOf([&] { forceIn("", "990"); }));
}

TEST(Inertial, RefusesAccelerationsThatNothingHas) {
  EXPECT_EQ(inertialRefusal(kBoth + std::string("1,0,0,2,0,0,9\n2,0,0,3,0,1e308,9\n")),
            "m.csv:3: the acceleration is over 1e9 m/s^2");
}

TEST(Inertial, ReadsAttitudesToo) {
  std::string text = "t (s),qw,qx,qy,qz\n";
  for (int i = 0; i < 9; ++i) {
    text += std::to_string(0.1 * i) + "," + std::to_string(std::cos(0.1 * i)) + ",0,0," +
            std::to_string(std::sin(0.1 * i)) + "\n";
  }
  const InertialRecording recording = inertial(text);
  EXPECT_FALSE(recording.isMeasured);
  EXPECT_NEAR(recording.readings[4].rate.angularVelocity.z(), 2, 1e-4);
}

TEST(Inertial, SaysWhatATableHas) {
  const auto contents = [](const std::string& text, const std::string& name) {
    return contentsOf({text, name}, {});
  };
  EXPECT_TRUE(contents(std::string(kBoth) + "1,0,0,2,0,0,9\n", "a.csv").hasForce);
  EXPECT_TRUE(contents(std::string(kRateHeader) + "1,0,0,2\n", "a.csv").hasRates);
  const std::string logged = "time,seconds_elapsed,z,y,x\n1,0,2,0,0\n";
  EXPECT_TRUE(contents(logged, "Gyroscope.csv").hasRates);
  EXPECT_TRUE(contents(logged, "TotalAcceleration.csv").hasForce);
  EXPECT_FALSE(contents(logged, "Accelerometer.csv").hasForce);  // without gravity
  EXPECT_FALSE(contents("\"property\",\"value\"\n\"version\",\"1.1\"\n", "device.csv").hasRates);
}

TEST(Gaps, AreNotedWithWhatTheyMayCost) {
  // About 0.1 s without readings at 100 Hz, while the rate of 6 rad/s turns its slope
  std::string text = kRateHeader;
  for (int i = 0; i < 60; ++i) {
    if (i > 20 && i < 30) continue;
    const double t = 0.01 * i;
    text += std::to_string(t) + "," + std::to_string(6 * std::cos(6 * t)) + ",0," +
            std::to_string(6 * std::sin(6 * t)) + "\n";
  }
  const RecordedMotion motion = readRecording(text, "m.csv", {});
  EXPECT_THAT(motion.notes(),
              ElementsAre(HasSubstr("a gap of 0.1 s from 0.2 s on, where readings are usually 0.01 "
                                    "s apart: what was between isn't known, and the attitude after "
                                    "may be off by ")));
  EXPECT_TRUE(readRecording(text, "m.csv", {.from = 0.3}).notes().empty());
}

}  // namespace
}  // namespace rotatebook::recording
