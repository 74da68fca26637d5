// Tables whose rates contradict their attitudes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "timeline/recorded_table.h"

namespace rotatebook::timeline {
namespace {

using physics::Integrator;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kDegree = 0.017453292519943295;

/// Returns what is said of a table; empty if it is read.
std::string mistakeIn(const Table& table, const physics::MotionSettings& motion = exactBook(),
                      const recording::ReadOptions& options = {}) {
  try {
    recording::readRecording(textOf(motion, table), "m.csv", options);
  } catch (const recording::ContradictionError& error) {
    return error.what();
  }
  return "";
}

TEST(WrongTable, RightOnesAreRead) {
  EXPECT_EQ(mistakeIn({}), "");
  EXPECT_EQ(mistakeIn({.rates = ""}), "");
  EXPECT_EQ(mistakeIn({.areAlongBody = true}, exactBook(), {.ratesAlong = "body"}), "");
  EXPECT_EQ(
      mistakeIn({.rates = "gyro_x (rad/s),gyro_y (rad/s),gyro_z (rad/s)", .areAlongBody = true}),
      "");
}

TEST(WrongTable, MotionsOfWrongStepsAreNoWrongTables) {
  for (const Integrator integrator :
       {Integrator::Euler, Integrator::ExplicitGyroscopic, Integrator::ImplicitGyroscopic,
        Integrator::NoGyroscopic, Integrator::Midpoint}) {
    for (const double framesASecond : {60.0, 25.0, 12.0})
      EXPECT_EQ(mistakeIn({}, thrownBook(integrator, framesASecond)), "") << framesASecond;
  }
}

TEST(WrongTable, RatesAlongTheBodysAxesAreFound) {
  EXPECT_THAT(mistakeIn({.areAlongBody = true}),
              AllOf(HasSubstr("m.csv: the rates are along the body's axes; state "
                              "simulation.rates_along = \"body\", or --rates-along body"),
                    Not(HasSubstr("times the"))));
  EXPECT_THAT(mistakeIn({}, exactBook(), {.ratesAlong = "body"}),
              HasSubstr("the rates are along the world's axes"));
  EXPECT_THAT(mistakeIn({.areAlongBody = true, .noise = 2e-3}), HasSubstr("along the body's axes"));
}

TEST(WrongTable, InverseQuaternionsAreFound) {
  EXPECT_THAT(
      mistakeIn({.isInverse = true}),
      AllOf(HasSubstr("the attitudes turn the world into the body"), Not(HasSubstr("along the"))));
  EXPECT_THAT(mistakeIn({.areAlongBody = true, .isInverse = true}),
              AllOf(HasSubstr("the attitudes turn the world into the body"),
                    HasSubstr("; and the rates are along the body's axes")));
}

TEST(WrongTable, QuaternionsInAnotherOrderAreFound) {
  EXPECT_THAT(mistakeIn({.isScalarLast = true}), HasSubstr("hold x, y, z, w"));
}

TEST(WrongTable, UnitsOfRatesAreFound) {
  EXPECT_THAT(mistakeIn({.ratesPerUnit = kDegree}),
              AllOf(HasSubstr("the rates are 57.3 times the attitudes' slopes: deg/s?"),
                    HasSubstr("--rates deg/s")));
  EXPECT_THAT(mistakeIn({}, exactBook(), {.unit = "deg/s"}), HasSubstr("rad/s?"));
  EXPECT_THAT(mistakeIn({.ratesPerUnit = 6.283185307179586}), HasSubstr("turns a second?"));
  EXPECT_THAT(mistakeIn({.ratesPerUnit = 6.283185307179586 / 60}), HasSubstr("turns a minute?"));
  EXPECT_THAT(mistakeIn({.ratesPerUnit = 2}), HasSubstr("0.5 times the attitudes' slopes"));
}

TEST(WrongTable, UnitsOfTimesAreFound) {
  EXPECT_THAT(mistakeIn({.secondsPerUnit = 1e-3}),
              AllOf(HasSubstr("1000 times the attitudes' slopes: are the times in ms?"),
                    HasSubstr("--time-unit ms")));
  EXPECT_THAT(mistakeIn({.secondsPerUnit = 1e-6}), HasSubstr("in us?"));
  EXPECT_THAT(mistakeIn({.time = "time_ms"}), HasSubstr("in s?"));
  EXPECT_EQ(mistakeIn({.secondsPerUnit = 1e-3}, exactBook(), {.timeUnit = "ms"}), "");
}

TEST(WrongTable, SeveralMistakesAreFoundTogether) {
  EXPECT_THAT(mistakeIn({.areAlongBody = true, .secondsPerUnit = 1e-3, .ratesPerUnit = kDegree}),
              AllOf(HasSubstr("along the body's axes"), HasSubstr("deg/s, and the times in ms?")));
}

TEST(WrongTable, AGyroscopesRatesThatFitNothingAreRefused) {
  Table other{.rates = "gyrX (rad/s),gyrY (rad/s),gyrZ (rad/s)", .rateNoise = 10};
  EXPECT_THAT(mistakeIn(other), HasSubstr("aren't the attitudes' slopes"));
}

}  // namespace
}  // namespace rotatebook::timeline
