// Tables whose rates contradict their attitudes.
#include <gtest/gtest.h>

#include "base/error.h"
#include "messages.h"
#include "timeline/recorded_table.h"

namespace rotatebook::timeline {
namespace {

using physics::Integrator;

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
  EXPECT_MESSAGE(mistakeIn({.areAlongBody = true}));
  EXPECT_MESSAGE(mistakeIn({}, exactBook(), {.ratesAlong = "body"}));
  EXPECT_MESSAGE(mistakeIn({.areAlongBody = true, .noise = 2e-3}));
}

TEST(WrongTable, InverseQuaternionsAreFound) {
  EXPECT_MESSAGE(mistakeIn({.isInverse = true}));
  EXPECT_MESSAGE(mistakeIn({.areAlongBody = true, .isInverse = true}));
}

TEST(WrongTable, QuaternionsInAnotherOrderAreFound) {
  EXPECT_MESSAGE(mistakeIn({.isScalarLast = true}));
}

TEST(WrongTable, UnitsOfRatesAreFound) {
  EXPECT_MESSAGE(mistakeIn({.ratesPerUnit = kDegree}));
  EXPECT_MESSAGE(mistakeIn({}, exactBook(), {.unit = "deg/s"}));
  EXPECT_MESSAGE(mistakeIn({.ratesPerUnit = 6.283185307179586}));
  EXPECT_MESSAGE(mistakeIn({.ratesPerUnit = 6.283185307179586 / 60}));
  EXPECT_MESSAGE(mistakeIn({.ratesPerUnit = 2}));
}

TEST(WrongTable, UnitsOfTimesAreFound) {
  EXPECT_MESSAGE(mistakeIn({.secondsPerUnit = 1e-3}));
  EXPECT_MESSAGE(mistakeIn({.secondsPerUnit = 1e-6}));
  EXPECT_MESSAGE(mistakeIn({.time = "time_ms"}));
  EXPECT_EQ(mistakeIn({.secondsPerUnit = 1e-3}, exactBook(), {.timeUnit = "ms"}), "");
}

TEST(WrongTable, TheUnitToStateIsNamedWhereAnotherWasStated) {
  EXPECT_MESSAGE(mistakeIn({.secondsPerUnit = 1e-6}, exactBook(), {.timeUnit = "ms"}));
  EXPECT_MESSAGE(mistakeIn({}, exactBook(), {.timeUnit = "ms"}));
  EXPECT_MESSAGE(mistakeIn({.secondsPerUnit = 1e-9}, exactBook(), {.timeUnit = "us"}));
  EXPECT_MESSAGE(mistakeIn({.time = "t (us)", .secondsPerUnit = 1e-3}));
  EXPECT_MESSAGE(mistakeIn({.secondsPerUnit = 1e-3, .ratesPerUnit = kDegree}, exactBook(),
                           {.unit = "rad/s", .timeUnit = "us"}));
  EXPECT_MESSAGE(
      mistakeIn({.ratesPerUnit = 6.283185307179586 / 60}, exactBook(), {.unit = "deg/s"}));
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
    EXPECT_MESSAGE(said(swapped, areAlongBody));
    EXPECT_MESSAGE(said(cycled, areAlongBody));
    EXPECT_MESSAGE(said(Eigen::Vector3d(1, -1, 1).asDiagonal(), areAlongBody));
    EXPECT_MESSAGE(said(Eigen::Vector3d(-1, 1, -1).asDiagonal(), areAlongBody));
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
  EXPECT_MESSAGE(mistakeIn({.isTurned = false, .spoil = negated}));
  EXPECT_MESSAGE(mistakeIn({.isTurned = false, .spoil = swapped}));
}

TEST(WrongTable, AttitudesOfTurnedAxesAreFound) {
  for (const double degrees : {30.0, 90.0}) {
    const Eigen::Quaterniond turn(
        Eigen::AngleAxisd(degrees * kDegree, Eigen::Vector3d(1, 2, 3).normalized()));
    const std::string angle = "by " + shortestText(degrees) + " degrees about";
    EXPECT_MESSAGE(mistakeIn({.worldTurn = turn}));
    EXPECT_MESSAGE(
        mistakeIn({.areAlongBody = true, .bodyTurn = turn}, exactBook(), {.ratesAlong = "body"}));
  }
}

TEST(WrongTable, ALargeBiasIsFound) {
  EXPECT_MESSAGE(mistakeIn({.bias = {0, 3, 0}}));
}

TEST(WrongTable, AttitudesThatStayAreFound) {
  const auto still = [](std::vector<physics::Sample>& samples) {
    for (physics::Sample& sample : samples) sample.attitude = samples.front().attitude;
  };
  EXPECT_MESSAGE(mistakeIn({.noise = 2e-3, .spoil = still}));
  EXPECT_MESSAGE(mistakeIn({.spoil = still}));
  const Table table{.rates = "gyro_x (rad/s),gyro_y (rad/s),gyro_z (rad/s)",
                    .areAlongBody = true,
                    .spoil = still};
  const recording::ReadOptions leftOut{.columns = {{"qw", ""}}};
  const auto alone = recording::readRecording(textOf(exactBook(), table), "m.csv", leftOut);
  EXPECT_EQ(alone.spins().source, recording::SpinSource::Gyroscope);
}

TEST(WrongTable, RatesOfAnotherMotionAreRefusedAlongTheWorldToo) {
  EXPECT_MESSAGE(mistakeIn({.rateNoise = 10}));
  const auto reversed = [](std::vector<physics::Sample>& samples) {
    const std::vector<physics::Sample> as = samples;
    for (std::size_t i = 0; i < as.size(); ++i)
      samples[i].angularVelocity = as[as.size() - 1 - i].angularVelocity;
  };
  EXPECT_MESSAGE(mistakeIn({.spoil = reversed}));
}

TEST(WrongTable, SeveralMistakesAreFoundTogether) {
  EXPECT_MESSAGE(
      mistakeIn({.areAlongBody = true, .secondsPerUnit = 1e-3, .ratesPerUnit = kDegree}));
}

TEST(WrongTable, AGyroscopesRatesThatFitNothingAreRefused) {
  Table other{.rates = "gyrX (rad/s),gyrY (rad/s),gyrZ (rad/s)", .rateNoise = 10};
  EXPECT_MESSAGE(mistakeIn(other));
}

}  // namespace
}  // namespace rotatebook::timeline
