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

TEST(WrongTable, TheUnitToStateIsNamedWhereAnotherWasStated) {
  EXPECT_THAT(mistakeIn({.secondsPerUnit = 1e-6}, exactBook(), {.timeUnit = "ms"}),
              AllOf(HasSubstr("are the times in us?"), HasSubstr("--time-unit us")));
  EXPECT_THAT(mistakeIn({}, exactBook(), {.timeUnit = "ms"}), HasSubstr("--time-unit s"));
  EXPECT_THAT(mistakeIn({.secondsPerUnit = 1e-9}, exactBook(), {.timeUnit = "us"}),
              HasSubstr("--time-unit ns"));
  EXPECT_THAT(mistakeIn({.time = "t (us)", .secondsPerUnit = 1e-3}), HasSubstr("--time-unit ms"));
  EXPECT_THAT(mistakeIn({.secondsPerUnit = 1e-3, .ratesPerUnit = kDegree}, exactBook(),
                        {.unit = "rad/s", .timeUnit = "us"}),
              HasSubstr("State --rates deg/s and --time-unit ms"));
  EXPECT_THAT(mistakeIn({.ratesPerUnit = 6.283185307179586 / 60}, exactBook(), {.unit = "deg/s"}),
              HasSubstr("turns a minute?"));
}

TEST(WrongTable, SwappedAndNegatedColumnsAreNamed) {
  const auto said = [](const Eigen::Matrix3d& columns, bool areAlongBody) {
    return mistakeIn({.areAlongBody = areAlongBody, .columns = columns}, exactBook(),
                     {.ratesAlong = areAlongBody ? "body" : "world"});
  };
  Eigen::Matrix3d swapped, cycled;
  swapped << 0, 1, 0, 1, 0, 0, 0, 0, 1;
  cycled << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  for (const bool areAlongBody : {false, true}) {
    EXPECT_THAT(said(swapped, areAlongBody),
                HasSubstr("m.csv: the columns wx, wy, wz hold wy, wx, wz; name them in"));
    EXPECT_THAT(said(cycled, areAlongBody), HasSubstr("wx, wy, wz hold wy, wz, wx;"));
    EXPECT_THAT(said(Eigen::Vector3d(1, -1, 1).asDiagonal(), areAlongBody),
                HasSubstr("the column wy has the other sign; negate it"));
    EXPECT_THAT(said(Eigen::Vector3d(-1, 1, -1).asDiagonal(), areAlongBody),
                HasSubstr("the columns wx, wz have the other sign; negate them; or else the "
                          "columns qx, qz have"));
  }
}

TEST(WrongTable, SwappedAndNegatedPartsOfQuaternionsAreNamed) {
  const auto negated = [](std::vector<physics::Sample>& samples) {
    for (physics::Sample& sample : samples) sample.attitude.x() = -sample.attitude.x();
  };
  const auto swapped = [](std::vector<physics::Sample>& samples) {
    for (physics::Sample& sample : samples) std::swap(sample.attitude.x(), sample.attitude.y());
  };
  // The rest of the table isn't turned, so that the quaternion's parts are as they are written.
  EXPECT_THAT(mistakeIn({.isTurned = false, .spoil = negated}),
              HasSubstr("the column qx has the other sign"));
  EXPECT_THAT(mistakeIn({.isTurned = false, .spoil = swapped}),
              HasSubstr("the columns qx, qy, qz hold qy, qx, qz"));
}

TEST(WrongTable, AttitudesOfTurnedAxesAreFound) {
  for (const double degrees : {30.0, 90.0}) {
    const Eigen::Quaterniond turn(
        Eigen::AngleAxisd(degrees * kDegree, Eigen::Vector3d(1, 2, 3).normalized()));
    const std::string angle = "by " + shortestText(degrees) + " degrees about";
    EXPECT_THAT(mistakeIn({.worldTurn = turn}),
                HasSubstr("the attitudes' world is turned from that of the rates, " + angle));
    EXPECT_THAT(
        mistakeIn({.areAlongBody = true, .bodyTurn = turn}, exactBook(), {.ratesAlong = "body"}),
        HasSubstr("the attitudes' body is turned from that of the rates, " + angle));
  }
}

TEST(WrongTable, ALargeBiasIsFound) {
  EXPECT_THAT(mistakeIn({.bias = {0, 3, 0}}),
              HasSubstr("the rates have a bias of (0, 3, 0) rad/s along the world's axes; undo"));
}

TEST(WrongTable, AttitudesThatStayAreFound) {
  const auto still = [](std::vector<physics::Sample>& samples) {
    for (physics::Sample& sample : samples) sample.attitude = samples.front().attitude;
  };
  EXPECT_THAT(mistakeIn({.noise = 2e-3, .spoil = still}),
              HasSubstr("degrees in all, and the rates by 36"));
  EXPECT_THAT(mistakeIn({.spoil = still}),
              AllOf(HasSubstr("m.csv: the quaternions stay (0."),
                    HasSubstr(") in all rows, though the rates turn the body by 36"),
                    HasSubstr("leave them out: state simulation.columns = { qw = \"\" }, or "
                              "--column qw=")));
  const Table table{.rates = "gyro_x (rad/s),gyro_y (rad/s),gyro_z (rad/s)",
                    .areAlongBody = true,
                    .spoil = still};
  const recording::ReadOptions leftOut{.columns = {{"qw", ""}}};
  const auto alone = recording::readRecording(textOf(exactBook(), table), "m.csv", leftOut);
  EXPECT_EQ(alone.spins().source, recording::SpinSource::Gyroscope);
}

TEST(WrongTable, RatesOfAnotherMotionAreRefusedAlongTheWorldToo) {
  EXPECT_THAT(mistakeIn({.rateNoise = 10}), HasSubstr("aren't the attitudes' slopes"));
  const auto reversed = [](std::vector<physics::Sample>& samples) {
    const std::vector<physics::Sample> as = samples;
    for (std::size_t i = 0; i < as.size(); ++i)
      samples[i].angularVelocity = as[as.size() - 1 - i].angularVelocity;
  };
  EXPECT_THAT(mistakeIn({.spoil = reversed}), HasSubstr("aren't the attitudes' slopes"));
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
