#include "recording/read_recording.h"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "messages.h"
#include "recording/refusal.h"
#include "recording/tumbling.h"

namespace rotatebook::recording {
namespace {

RecordedMotion motionOf(const std::string& text, const ReadOptions& options = {}) {
  return readRecording(text, "m.csv", options);
}

std::string refusal(const std::string& text, const ReadOptions& options = {}) {
  return refusalOf([&] { motionOf(text, options); });
}

Eigen::Vector3d startOf(const RecordedMotion& motion) {
  return motion.moments().front().angularVelocity;
}

TEST(ReadRecording, IntegratesExportsOfPhyphox) {
  for (const char* const text :
       {"\"Time (s)\",\"Gyroscope x (rad/s)\",\"Gyroscope y (rad/s)\",\"Gyroscope z "
        "(rad/s)\",\"Absolute (rad/s)\"\n0.1,0,0,2,2\n0.2,0,0,2,2\n0.4,0,0,2,2\n",
        "\"Time (s)\"\t\"Gyroscope x (rad/s)\"\t\"Gyroscope y (rad/s)\"\t\"Gyroscope z "
        "(rad/s)\"\n1,0E-1\t0\t0\t2\n2,0E-1\t0\t0\t2\n4,0E-1\t0\t0\t2\n",
        "\"Time (s)\";\"Gyroscope x (rad/s)\";\"Gyroscope y (rad/s)\";\"Gyroscope z "
        "(rad/s)\"\n0,1;0;0;2\n0,2;0;0;2\n0,4;0;0;2\n"}) {
    const RecordedMotion motion = motionOf(text);
    EXPECT_NEAR(motion.duration(), 0.3, 1e-15);
    EXPECT_EQ(startOf(motion), Eigen::Vector3d(0, 0, 2));
    EXPECT_NEAR(turnOf(motion.moments().back().attitude).z(), 0.6, 1e-14);
  }
}

TEST(ReadRecording, TakesTheUnitOfRatesFromTheHeaderOrTheOptions) {
  const std::string rows = "\n0,0,0,90\n.01,0,0,90\n";
  const double rate = 90 * kDegree;
  EXPECT_EQ(startOf(motionOf("t,wx (deg/s),wy (deg/s),wz (deg/s)" + rows)).z(), rate);
  EXPECT_EQ(startOf(motionOf("t,gyrX (\xC2\xB0/s),gyrY (\xC2\xB0/s),gyrZ (\xC2\xB0/s)" + rows)).z(),
            rate);
  EXPECT_EQ(startOf(motionOf("t,wx,wy,wz" + rows, {.unit = "deg/s"})).z(), rate);
  EXPECT_EQ(startOf(motionOf("t,wx,wy,wz" + rows, {.unit = "rad/s"})).z(), 90);
  EXPECT_EQ(refusal("t,wx,wy,wz" + rows),
            "m.csv: the column \"wx\" doesn't say whether it is in rad/s or deg/s; state it in "
            "simulation.rates, or with --rates");
  for (const char* unit : {"rad/min", "counts", "gon/s"}) {
    const std::string u = std::string(" (") + unit + ")";
    EXPECT_MESSAGE(refusal("t,wx" + u + ",wy" + u + ",wz" + u + rows));
  }
  EXPECT_EQ(
      refusal("t,wx (rad/s),wy (deg/s),wz (rad/s)" + rows),
      "m.csv: the columns \"wx (rad/s)\" and \"wy (deg/s)\" are in different units; state one "
      "for all in simulation.rates, or with --rates");
}

TEST(ReadRecording, KnowsRatesByTheirLetter) {
  EXPECT_EQ(refusal("t,\xCF\x89x (rad/s),\xCF\x89y (rad/s),\xCF\x89z (rad/s)\n1,0,0,1\n2,0,0,1\n"),
            "");
}

TEST(ReadRecording, TakesTheUnitOfTimesFromTheHeader) {
  const std::string rates = ",wx (rad/s),wy (rad/s),wz (rad/s)\n0,0,0,9\n500,0,0,9\n";
  for (const char* time : {"t (ms)", "time_ms", "Time [ms]", "time ( ms )"})
    EXPECT_NEAR(motionOf(time + rates).duration(), 0.5, 1e-15) << time;
  EXPECT_NEAR(motionOf("t (\xC2\xB5s)" + rates).duration(), 5e-4, 1e-18);
  EXPECT_EQ(
      refusal("t (h)" + rates),
      "m.csv: the column \"t (h)\" has times in a unit that isn't read; there are s, ms, us, ns "
      "and min: write them in one, or, if they are, state it in simulation.time_unit, or with "
      "--time-unit");
  EXPECT_MESSAGE(refusal("t,wx (rad/s),wy (rad/s),wz (rad/s)\nabc,0,0,9\n1,0,0,9\n"));
}

TEST(ReadRecording, TakesNamedColumns) {
  const std::string text = "a,b,c,d\n0,1,2,3\n.1,1,2,3\n";
  const ReadOptions options{.columns = {{"time", "a"}, {"wx", "d"}, {"wy", "b"}, {"wz", "c"}},
                            .unit = "rad/s"};
  EXPECT_EQ(startOf(motionOf(text, options)), Eigen::Vector3d(3, 1, 2));
  EXPECT_MESSAGE(refusal(text, {.columns = {{"time", "e"}}}));
  EXPECT_EQ(refusal(text),
            "m.csv: no column of times among \"a\", \"b\", \"c\" and \"d\"; name it in "
            "simulation.columns, or with --column");
}

TEST(ReadRecording, DifferentiatesAttitudesAlone) {
  std::string quaternions = "time_ms,qw,qx,qy,qz\n";
  std::string matrices = "t,r11,r12,r13,r21,r22,r23,r31,r32,r33\n";
  for (int i = 0; i < 20; ++i) {
    const double angle = 0.3 * i;  // of 3 rad/s about z
    quaternions += std::to_string(100 * i) + "," + std::to_string(std::cos(angle / 2)) + ",0,0," +
                   std::to_string(std::sin(angle / 2)) + "\n";
    const std::string c = std::to_string(std::cos(angle)), s = std::to_string(std::sin(angle));
    matrices += std::to_string(0.1 * i) + "," + c + ",-" + s + ",0," + s + "," + c + ",0,0,0,1\n";
  }
  std::string::size_type at = 0;
  while ((at = matrices.find("--")) != std::string::npos) matrices.erase(at, 2);
  for (const std::string& text : {quaternions, matrices}) {
    const RecordedMotion motion = motionOf(text);
    EXPECT_NEAR(motion.duration(), 1.9, 1e-9);
    EXPECT_LT((motion.moments()[9].angularVelocity - Eigen::Vector3d(0, 0, 3)).norm(), 1e-4);
  }
}

TEST(ReadRecording, TakesRatesBesideAttitudesAlongTheWorldsAxes) {
  const double half = std::sqrt(0.5);
  const std::string turned = std::to_string(half);
  // Turned by 90 degrees about x: the world's y is the body's -z... z of the body is -y of the
  // world.
  const std::string row = "," + turned + "," + turned + ",0,0,0,1,0\n";
  const RecordedMotion motion = motionOf("time_s,qw,qx,qy,qz,wx,wy,wz\n0" + row + "1" + row);
  EXPECT_LT((startOf(motion) - Eigen::Vector3d(0, 0, -1)).norm(), 1e-6);
}

TEST(ReadRecording, TakesAPart) {
  const std::string text = "t,wx (rad/s),wy (rad/s),wz (rad/s)\n10,0,0,.1\n11,0,0,.2\n12,0,0,.3\n";
  const RecordedMotion motion = motionOf(text, {.from = 10.5, .to = 11.5});
  EXPECT_EQ(motion.duration(), 1);
  EXPECT_NEAR(startOf(motion).z(), 0.15, 1e-15);
  EXPECT_NEAR(turnOf(motion.moments().back().attitude).z(), 0.2, 1e-4);  // of a cubic
  EXPECT_EQ(refusal(text, {.from = 9}),
            "m.csv: the part from 9 to 12 s isn't within the recording, which lasts from 10 to 12 "
            "s");
  EXPECT_EQ(startOf(motionOf(text, {.bias = {0, 0, 0.05}})).z(), 0.05);
}

TEST(ReadRecording, NamesTheLineOfWhatItRefuses) {
  const std::string rates = "t (s),wx (rad/s),wy (rad/s),wz (rad/s)\n";
  EXPECT_EQ(refusal(rates + "1,0,0,1\n1,0,0,1\n"),
            "m.csv:3: the time 1 s is that of the row before, too; write times that ascend, with "
            "all their digits, or leave such rows out");
  EXPECT_MESSAGE(refusal(rates + "1,0,0,1\n.5,0,0,1\n"));
  const auto ofTime = [&](const std::string& cell) {
    return refusal(rates + cell + ",0,0,1\n" + cell + "1,0,0,1\n");
  };
  EXPECT_EQ(ofTime("12:03:04.5"),
            "m.csv:2: the column \"t (s)\" has \"12:03:04.5\", which is a time of day; write "
            "seconds, as since the start");
  EXPECT_MESSAGE(ofTime("2026-05-03"));
  EXPECT_MESSAGE(ofTime("3/5/2026"));
  EXPECT_MESSAGE(ofTime("2026-05-03T12:03:04.5Z"));
  EXPECT_MESSAGE(ofTime("soon"));
  EXPECT_EQ(refusal(rates + "1,0,0,1\n"), "m.csv: a single row; a motion takes at least two");
  EXPECT_EQ(refusal(rates + "1,0,0,1\n2,0,0,2e9\n"), "m.csv:3: the rate is over 1e9 rad/s");
  EXPECT_MESSAGE(refusal(rates + "1,0,0,1\n2000,0,0,1\n"));
  EXPECT_EQ(refusal("t,qw,qx,qy,qz\n1,1,0,0,0\n2,1,1,0,0\n"),
            "m.csv:3: the quaternion's norm is 1.414, not 1");
  EXPECT_EQ(refusal("t,r11,r12,r13,r21,r22,r23,r31,r32,r33\n"
                    "1,1,0,0,0,1,0,0,0,-1\n2,1,0,0,0,1,0,0,0,1\n"),
            "m.csv:2: r11 to r33 are no rotation");
  EXPECT_EQ(refusal("t,qw,qx,qy\n1,1,0,0\n"),
            "m.csv: no column for qz among \"t\", \"qw\", \"qx\" and \"qy\"; name it in "
            "simulation.columns, or with --column");
  EXPECT_MESSAGE(refusal("t,x,y,z\n1,1,0,0\n"));
}

}  // namespace
}  // namespace rotatebook::recording
