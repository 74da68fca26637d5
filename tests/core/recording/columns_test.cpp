#include "recording/columns.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "messages.h"
#include "recording/read_recording.h"
#include "recording/refusal.h"
#include "recording/tumbling.h"

namespace rotatebook::recording {
namespace {

constexpr const char* kRateNames = ",wx (rad/s),wy (rad/s),wz (rad/s)";

/// Returns rows at ascending times of a step, with the rates 0, 0, 2.
std::string rowsAt(const std::string& first, long long step) {
  const long long start = std::stoll(first);
  std::string text = "\n";
  for (int i = 0; i < 5; ++i) text += std::to_string(start + i * step) + ",0,0,2\n";
  return text;
}

double durationOf(const std::string& text, const ReadOptions& options = {},
                  const std::string& name = "m.csv") {
  return readRecording(text, name, options).duration();
}

std::string columnsRefusal(const std::string& text, const ReadOptions& options = {},
                           const std::string& name = "m.csv") {
  return refusalOf([&] { readRecording(text, name, options); });
}

TEST(Columns, ReadUnitsOfTimesHoweverTheyAreSpelt) {
  for (const char* time :
       {"timeMs", "time_ms", "t (ms)", "Time since start in ms", "time_millis", "timestamp msec",
        "elapsedTimeMillis", "timestamp_ms", "timems", "TimeMS", "time [milliseconds]"}) {
    const std::string text = time + std::string(kRateNames) + rowsAt("100", 10);
    EXPECT_NEAR(durationOf(text, {.columns = {{"time", time}}}), 0.04, 1e-12) << time;
  }
  for (const char* time : {"TimeUS", "time_us", "t_micros", "timestamp [us]", "SampleTimeFine",
                           "SampleTimeFine_us", "time_usec", "elapsed_microseconds"}) {
    const std::string text = time + std::string(kRateNames) + rowsAt("0", 10'000);
    EXPECT_NEAR(durationOf(text, {.columns = {{"time", time}}}), 0.04, 1e-12) << time;
  }
  for (const char* time : {"time_ns", "timestamp [ns]", "timeNanos", "timestamp_nsec"}) {
    const std::string text =
        time + std::string(kRateNames) + rowsAt("1403636579758555392", 10'000'000);
    EXPECT_NEAR(durationOf(text), 0.04, 1e-15) << time;  // measured 3.5e-17
  }
  for (const char* time : {"time_s", "seconds_elapsed", "Zeit (s)", "elapsed (s)", "t_sec"}) {
    EXPECT_EQ(durationOf(time + std::string(kRateNames) + rowsAt("0", 20)), 80) << time;
  }
}

TEST(Columns, RefuseTimesThatAreNoPlausibleSeconds) {
  EXPECT_EQ(columnsRefusal("timestamp" + std::string(kRateNames) + rowsAt("0", 10)),
            "m.csv: the column \"timestamp\" doesn't state its unit, and in seconds its rows are "
            "10 s apart; it seems to be ms: state it in simulation.time_unit, or with --time-unit "
            "ms");
  const auto seeming = [](const std::string& first, long long step) {
    return columnsRefusal("t" + std::string(kRateNames) + rowsAt(first, step));
  };
  EXPECT_MESSAGE(seeming("0", 4000));
  EXPECT_MESSAGE(seeming("0", 10'000'000));
  EXPECT_MESSAGE(seeming("1727600000000", 1));
  EXPECT_MESSAGE(seeming("1727600000000000", 10'000));
  EXPECT_MESSAGE(seeming("1727600000000000000", 10'000'000));
  // Whole milliseconds at 1 kHz, in which the body would turn by 20 rad from row to row
  EXPECT_MESSAGE(
      columnsRefusal("t" + std::string(kRateNames) + "\n0,0,0,20\n1,0,0,20\n2,0,0,20\n"));
  // Minutes, of a throw at 100 Hz
  std::string minutes;
  for (int i = 0; i < 100; ++i) minutes += "\n" + std::to_string(i / 6000.0) + ",0,0,12";
  EXPECT_EQ(
      columnsRefusal("t" + std::string(kRateNames) + minutes),
      "m.csv: the column \"t\" doesn't state its unit, and in seconds its rows are 0.000167 s "
      "apart and the body turns by 0.2 rad in all; it seems to be min: state it in "
      "simulation.time_unit, or with --time-unit min");
  for (const char* header : {"t (min)", "time_min", "time in minutes"}) {
    EXPECT_NEAR(durationOf(header + std::string(kRateNames) + minutes), 0.99, 1e-9) << header;
  }
  EXPECT_NEAR(durationOf("t (min)" + std::string(kRateNames) + rowsAt("29000000", 1)), 240, 1e-9);
  EXPECT_NEAR(durationOf("t" + std::string(kRateNames) + minutes, {.timeUnit = "min"}), 0.99, 1e-9);
  EXPECT_NEAR(durationOf("t" + std::string(kRateNames) + minutes, {.timeUnit = "s"}), 0.0165, 1e-9);
  // A stated unit is believed.
  const std::string rows = rowsAt("0", 10);
  EXPECT_EQ(durationOf("t" + std::string(kRateNames) + rows, {.timeUnit = "s"}), 40);
  EXPECT_NEAR(durationOf("t" + std::string(kRateNames) + rows, {.timeUnit = "ms"}), 0.04, 1e-12);
  EXPECT_EQ(durationOf("t (s)" + std::string(kRateNames) + rows), 40);
}

TEST(Columns, TakeEpochsAtAThousandReadingsASecond) {
  const std::string text =
      "timestamp (s)" + std::string(kRateNames) +
      "\n1727600000.0000,0,0,2\n1727600000.0010,0,0,2\n1727600000.0020,0,0,2\n";
  EXPECT_DOUBLE_EQ(durationOf(text), 2e-3);
  EXPECT_MESSAGE(columnsRefusal("t (s)" + std::string(kRateNames) +
                                "\n1727600000,0,0,2\n1727600000.0000000001,0,0,2\n"));
}

TEST(Columns, TakeXYZForTheSensorThatTheUnitOrTheFileSays) {
  const std::string rows = "\n0,0,0,2\n.1,0,0,2\n";
  EXPECT_NEAR(durationOf("\"Time (s)\",\"X (rad/s)\",\"Y (rad/s)\",\"Z (rad/s)\"" + rows), 0.1,
              1e-15);
  EXPECT_NEAR(durationOf("elapsed (s),x-axis (deg/s),y-axis (deg/s),z-axis (deg/s)" + rows), 0.1,
              1e-15);
  const std::string logged = "time,seconds_elapsed,z,y,x\n1,0,2,0,0\n2,.1,2,0,0\n";
  const RecordedMotion motion = readRecording(logged, "run/Gyroscope.csv", {});
  EXPECT_EQ(motion.moments().front().angularVelocity, Eigen::Vector3d(0, 0, 2));
  EXPECT_EQ(motion.duration(), 0.1);
  EXPECT_MESSAGE(columnsRefusal(logged));
  EXPECT_MESSAGE(columnsRefusal("t,x,y,z" + rows, {}, "Gyroscope.csv"));
  EXPECT_MESSAGE(columnsRefusal("t,X (m/s^2),Y (m/s^2),Z (m/s^2)" + rows));
}

TEST(Columns, KnowTheUnitsOfProgramsThatWriteNone) {
  const RecordedMotion motion =
      readRecording("SampleTimeFine,Gyr_X,Gyr_Y,Gyr_Z\n0,0,0,90\n10000,0,0,90\n", "m.csv", {});
  EXPECT_EQ(motion.moments().front().angularVelocity.z(), 90 * kDegree);
  EXPECT_EQ(motion.duration(), 0.01);
}

// Rows 20000 ticks of 0.1 ms or 1 us apart, at 0.5 and 50 Hz: MT Manager's are at 2 Hz and more.
TEST(Columns, TellXsensTicksByTheirSteps) {
  const auto text = [](long long step) {
    return "SampleTimeFine,Gyr_X,Gyr_Y,Gyr_Z" + rowsAt("4294900000", step);
  };
  for (const long long step : {5, 10, 25, 100, 167, 1000, 4999})  // 2 kHz to 2 Hz
    EXPECT_NEAR(durationOf(text(step)), 4e-4 * static_cast<double>(step), 1e-9) << step;
  for (const long long step : {8333, 16'667, 33'333, 66'667, 1'000'000})  // 120 to 1 Hz
    EXPECT_NEAR(durationOf(text(step)), 4e-6 * static_cast<double>(step), 1e-9) << step;
  EXPECT_NEAR(durationOf(text(100), {.timeUnit = "us"}), 4e-4, 1e-9) << "it is stated";
}

TEST(Columns, SayWhichHasNoNumbers) {
  const std::string names = "PacketCounter,SampleTimeFine,Gyr_X,Gyr_Y,Gyr_Z\n";
  for (const char* hole : {"", "NaN"}) {
    const std::string rest = std::string(",") + hole + ",0,0,2\n";
    EXPECT_EQ(columnsRefusal(names + "1" + rest + "2" + rest + "3" + rest),
              "m.csv: the column \"SampleTimeFine\" has no number in any row; export it with them, "
              "or name another in simulation.columns, or with --column");
  }
  EXPECT_EQ(columnsRefusal("timestamp" + std::string(kRateNames) +
                           "\n2024-05-01 12:00:00.00,0,0,2\n2024-05-01 12:00:00.01,0,0,2\n"),
            "m.csv:2: the column \"timestamp\" has \"2024-05-01 12:00:00.00\", which is a date "
            "with a time of day; write seconds, as since the start");
}

TEST(Columns, OfTheSameNameAreRefused) {
  const std::string rows = "\n0,0,0,2,1\n.1,0,0,2,1\n";
  EXPECT_EQ(
      columnsRefusal("t,wx (rad/s),wy (rad/s),wz (rad/s),wz (rad/s)" + rows),
      "m.csv: the columns 4 and 5, \"wz (rad/s)\" and \"wz (rad/s)\", hold the same; give one "
      "of them another name, or put what belongs to it in another table");
  const std::string text = "t,gyro_x,gyro_y,gyro_z,Gyro Z (deg/s)" + rows;
  EXPECT_MESSAGE(columnsRefusal(text, {.unit = "rad/s"}));
  EXPECT_EQ(durationOf(text, {.columns = {{"wz", "gyro_z"}}, .unit = "rad/s"}), 0.1);
  EXPECT_MESSAGE(columnsRefusal("Time (s),wx (rad/s),wy (rad/s),wz (rad/s),Time (s)" + rows));
}

TEST(Columns, SpellUnitsOfRatesInManyWays) {
  for (const char* unit : {"rad s-1", "rad s^-1", "rad\xC2\xB7s\xE2\x81\xBB\xC2\xB9", "rad/sec"}) {
    const std::string u = std::string(" [") + unit + "]";
    const std::string text = "t,wx" + u + ",wy" + u + ",wz" + u + "\n0,0,0,2\n.1,0,0,2\n";
    EXPECT_EQ(durationOf(text), 0.1) << unit;
  }
  EXPECT_EQ(durationOf("t,gyro_x_radps,gyro_y_radps,gyro_z_radps\n0,0,0,2\n.1,0,0,2\n"), 0.1);
  // A degree sign of Latin-1
  EXPECT_EQ(durationOf("t;gx (\xB0/s);gy (\xB0/s);gz (\xB0/s)\n0;0;0;2\n0,1;0;0;2\n"), 0.1);
}

TEST(Columns, ReadUnitsInTheNamesOfRates) {
  const auto rateOf = [](const std::string& unit) {
    const std::string names = "time_s,gyro_x_" + unit + ",gyro_y_" + unit + ",gyro_z_" + unit;
    return readRecording(names + rowsAt("0", 1), "m.csv", {}).moments().front().angularVelocity.z();
  };
  for (const char* unit : {"radps", "rad_s", "rads"}) EXPECT_EQ(rateOf(unit), 2) << unit;
  for (const char* unit : {"dps", "degps", "deg_s"})
    EXPECT_NEAR(rateOf(unit), 0.0349, 1e-4) << unit;
  for (const char* unit : {"mdps", "millideg_s"}) EXPECT_NEAR(rateOf(unit), 3.49e-5, 1e-7) << unit;
}

TEST(Columns, AreFoundInEuRoCsAndTumsTables) {
  const std::string euroc =
      "#timestamp [ns],w_RS_S_x [rad s^-1],w_RS_S_y [rad s^-1],w_RS_S_z [rad s^-1],"
      "a_RS_S_x [m s^-2],a_RS_S_y [m s^-2],a_RS_S_z [m s^-2]\r\n"
      "1403636579758555392,0,0,2,0,0,9.8\r\n1403636579858555392,0,0,2,0,0,9.8\r\n";
  EXPECT_NEAR(durationOf(euroc), 0.1, 1e-6);
  EXPECT_TRUE(readInertial(euroc, "m.csv", {}).hasForce);
  const std::string tum =
      "# ground truth trajectory\n# timestamp tx ty tz qx qy qz qw\n"
      "1305031098.6659 1.3 0.6 1.6 0 0 0 1\n1305031098.6758  1.3 0.6 1.6 0 0 0 1\n";
  EXPECT_NEAR(durationOf(tum), 0.0099, 1e-6);
}

}  // namespace
}  // namespace rotatebook::recording
