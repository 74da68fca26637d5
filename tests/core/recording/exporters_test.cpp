// Tables as programs and phones export them: which columns are taken, in which units.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "messages.h"
#include "recording/columns.h"
#include "recording/read_recording.h"
#include "recording/refusal.h"
#include "recording/tumbling.h"

namespace rotatebook::recording {
namespace {

/// A program's table: its header, two rows 0.01 s apart, and what they are.
struct Export {
  const char* program;
  std::string text;
  double rate = 2;        // about z [rad/s]
  bool isAlone = true;    // without attitudes
  bool isTurned = false;  // by a right angle about x
};

const std::vector<Export>& exports() {
  static const std::vector<Export> all{
      {"rostopic",
       "%time,field.header.seq,field.header.stamp,field.header.frame_id,field.orientation.x,"
       "field.orientation.y,field.orientation.z,field.orientation.w,field.orientation_covariance0,"
       "field.angular_velocity.x,field.angular_velocity.y,field.angular_velocity.z,"
       "field.angular_velocity_covariance0,field.linear_acceleration.x,"
       "field.linear_acceleration.y,field.linear_acceleration.z\n"
       "1403636579768555392,1,1403636579758555392,imu,0,0,0,0,-1,0,0,2,0,0,0,9.8\n"
       "1403636579778555392,2,1403636579768555392,imu,0,0,0,0,-1,0,0,2,0,0,0,9.8\n"},
      {"a message of ROS",
       "header.stamp.secs,header.stamp.nsecs,angular_velocity.x,angular_velocity.y,"
       "angular_velocity.z\n1403636579,995000000,0,0,2\n1403636580,5000000,0,0,2\n"},
      {"PlotJuggler",
       "__time,/imu/data/angular_velocity/x,/imu/data/angular_velocity/y,"
       "/imu/data/angular_velocity/z\n1700000000.25,0,0,2\n1700000000.26,0,0,2\n"},
      {"PX4",
       "timestamp_us,gyro_rad[0],gyro_rad[1],gyro_rad[2],accelerometer_m_s2[0],"
       "accelerometer_m_s2[1],accelerometer_m_s2[2]\n0,0,0,2,0,0,9.8\n10000,0,0,2,0,0,9.8\n"},
      {"an attitude of PX4",
       "time_us,q[0],q[1],q[2],q[3],wx,wy,wz\n"
       "0,.7071068,.7071068,0,0,0,2,0\n10000,.7071068,.7071068,0,0,0,2,0\n",
       2, false, true},
      {"q0 to q3",
       "t (s),q0,q1,q2,q3,wx,wy,wz\n"
       "0,.7071068,.7071068,0,0,0,2,0\n.01,.7071068,.7071068,0,0,0,2,0\n",
       2, false, true},
      {"MT Manager",
       "PacketCounter,time_ms,Gyr_X (rad/s),Gyr_Y (rad/s),Gyr_Z (rad/s),Quat_q0,"
       "Quat_q1,Quat_q2,Quat_q3\n7,0,0,0,2,1,0,0,0\n8,10,0,0,2,1,0,0,0\n",
       2, false},
      {"MT Manager's rates",
       "// General information: \n//  MT Manager version: 2022.2.0 \n// Coordinate system: ENU\n"
       "PacketCounter\tSampleTimeFine\tAcc_X\tAcc_Y\tAcc_Z\tGyr_X\tGyr_Y\tGyr_Z\tRoll\n"
       "7\t123400\t0\t0\t9.8\t0\t0\t2\t1\n8\t123500\t0\t0\t9.8\t0\t0\t2\t1\n"},
      {"MT Manager's rates beside its attitudes",
       "// Update Rate: 100.0Hz\nPacketCounter\tSampleTimeFine\tGyr_X\tGyr_Y\tGyr_Z\tQuat_q0\t"
       "Quat_q1\tQuat_q2\tQuat_q3\n7\t0\t0\t0\t2\t1\t0\t0\t0\n"
       "8\t100\t0\t0\t2\t0.99995\t0\t0\t0.0099998\n",
       2, false},
      {"Movella DOT",
       "sep=,\nDeviceTag:,DOT 1\n\nPacketCounter,SampleTimeFine,Euler_X,Euler_Y,"
       "Euler_Z,Acc_X,Acc_Y,Acc_Z,Gyr_X,Gyr_Y,Gyr_Z\n"
       "0,5000,1,2,3,0,0,9.8,0,0,2\n1,15000,1,2,3,0,0,9.8,0,0,2\n",
       2 * kDegree},
      {"Shimmer",
       "sep=,\nShimmer_DB18_Timestamp_Unix_CAL,Shimmer_DB18_Accel_LN_X_CAL,"
       "Shimmer_DB18_Accel_LN_Y_CAL,Shimmer_DB18_Accel_LN_Z_CAL,"
       "Shimmer_DB18_Gyro_X_CAL,Shimmer_DB18_Gyro_Y_CAL,Shimmer_DB18_Gyro_Z_CAL\n"
       "ms,m/(s^2),m/(s^2),m/(s^2),deg/s,deg/s,deg/s\n"
       "1.7E12,0,0,9.8,0,0,2\n1.70000000001E12,0,0,9.8,0,0,2\n",
       2 * kDegree},
      {"Shimmer's Consensys, of a unit that has a name",
       "\"sep=\t\"\nS_Head_Timestamp_Shimmer_CAL\tS_Head_Timestamp_Unix_CAL\t"
       "S_Head_Accel_WR_X_CAL\tS_Head_Accel_WR_Y_CAL\tS_Head_Accel_WR_Z_CAL\t"
       "S_Head_Gyro_X_CAL\tS_Head_Gyro_Y_CAL\tS_Head_Gyro_Z_CAL\t\n"
       "ms\tms\tm/(s^2)\tm/(s^2)\tm/(s^2)\tdeg/s\tdeg/s\tdeg/s\t\n"
       "5\t1.7E12\t0\t0\t9.8\t0\t0\t2\t\n15\t1.70000000001E12\t0\t0\t9.8\t0\t0\t2\t\n",
       2 * kDegree},
      {"Shimmer's units, synchronised",
       "sep=,\nShimmer_DB18_TimestampSync_Unix_CAL,Shimmer_DB18_Gyro_X_CAL,"
       "Shimmer_DB18_Gyro_Y_CAL,Shimmer_DB18_Gyro_Z_CAL\nms,deg/s,deg/s,deg/s\n"
       "1.7E12,0,0,2\n1.70000000001E12,0,0,2\n",
       2 * kDegree},
      {"ShimmerConnect",
       "Shimmer 1\tShimmer 1\tShimmer 1\tShimmer 1\tShimmer 1\tShimmer 1\tShimmer 1\n"
       "Timestamp\tLow Noise Accelerometer X\tLow Noise Accelerometer Y\t"
       "Low Noise Accelerometer Z\tGyroscope X\tGyroscope Y\tGyroscope Z\n"
       "CAL\tCAL\tCAL\tCAL\tCAL\tCAL\tCAL\n"
       "mSecs\tm/(sec^2)*\tm/(sec^2)*\tm/(sec^2)*\tdeg/sec*\tdeg/sec*\tdeg/sec*\n"
       "5\t0\t0\t9.8\t0\t0\t2\n15\t0\t0\t9.8\t0\t0\t2\n",
       2 * kDegree},
      {"ShimmerConnect, with raw readings",
       "Shimmer 1\tShimmer 1\tShimmer 1\tShimmer 1\tShimmer 1\tShimmer 1\tShimmer 1\tShimmer 1\n"
       "Timestamp\tTimestamp\tGyroscope X\tGyroscope X\tGyroscope Y\tGyroscope Y\tGyroscope Z\t"
       "Gyroscope Z\nRAW\tCAL\tRAW\tCAL\tRAW\tCAL\tRAW\tCAL\n"
       "no units\tmSecs\tno units\tdeg/sec\tno units\tdeg/sec\tno units\tdeg/sec\n"
       "164\t5\t7\t0\t7\t0\t9\t2\n492\t15\t7\t0\t7\t0\t9\t2\n",
       2 * kDegree},
      {"SensorLog",
       "loggingTime(txt),loggingSample(N),motionYaw(rad),motionRotationRateX(rad/s),"
       "motionRotationRateY(rad/s),motionRotationRateZ(rad/s),motionTimestamp_sinceReboot(s),"
       "accelerometerAccelerationX(G),accelerometerAccelerationY(G),"
       "accelerometerAccelerationZ(G)\n2024-05-01 12:00:00,1,.1,0,0,2,.5,0,0,1\n"
       "2024-05-01 12:00:00,2,.1,0,0,2,.51,0,0,1\n"},
      {"Android", "Time(ms),GyroX(rad/s),GyroY(rad/s),GyroZ(rad/s)\n100,0,0,2\n110,0,0,2\n"},
      {"AndroSensor",
       "ACCELEROMETER X (m/s\xC2\xB2),ACCELEROMETER Y (m/s\xC2\xB2),ACCELEROMETER Z "
       "(m/s\xC2\xB2),GYROSCOPE X (rad/s),GYROSCOPE Y (rad/s),GYROSCOPE Z (rad/s),"
       "ORIENTATION X (\xC2\xB0),ORIENTATION Y (\xC2\xB0),ORIENTATION Z (\xC2\xB0),"
       "Time since start in ms,YYYY-MO-DD HH-MI-SS_SSS\n"
       "0,0,9.8,0,0,2,1,2,3,100,2024\n0,0,9.8,0,0,2,1,2,3,110,2024\n"},
      {"MetaWear",
       "epoc (ms),timestamp (-0500),elapsed (s),x-axis (deg/s),y-axis (deg/s),z-axis "
       "(deg/s)\n1527600000000,2018-05-29T08.00.00.000,0,0,0,2\n"
       "1527600000010,2018-05-29T08.00.00.010,.01,0,0,2\n",
       2 * kDegree},
      {"Arduino", "millis,ax_g,ay_g,az_g,gx_dps,gy_dps,gz_dps\n0,0,0,1,0,0,2\n10,0,0,1,0,0,2\n",
       2 * kDegree},
      {"MPU-6050",
       "ms\tAcX\tAcY\tAcZ\tTmp\tGyX (deg/s)\tGyY (deg/s)\tGyZ (deg/s)\n"
       "0\t0\t0\t9.8\t3\t0\t0\t2\n10\t0\t0\t9.8\t3\t0\t0\t2\n",
       2 * kDegree},
      {"milli-degrees", "time_s,gyro_x_mdps,gyro_y_mdps,gyro_z_mdps\n0,0,0,2000\n.01,0,0,2000\n",
       2 * kDegree},
      {"Vernier",
       "Data Set 1:Time(s),Data Set 1:X-gyro(rad/s),Data Set 1:Y-gyro(rad/s),"
       "Data Set 1:Z-gyro(rad/s)\n0,0,0,2\n.01,0,0,2\n"},
      {"Delsys",
       "X[s],t (s),Avanti 1: GYRO.X (deg/s),Avanti 1: GYRO.Y (deg/s),Avanti 1: GYRO.Z "
       "(deg/s)\n0,0,0,0,2\n.01,.01,0,0,2\n",
       2 * kDegree},
      {"MATLAB",
       "Time_s,AngularVelocity_1 (rad/s),AngularVelocity_2 (rad/s),AngularVelocity_3 "
       "(rad/s)\n0,0,0,2\n.01,0,0,2\n"},
      {"R",
       "Time..s.,Angular.velocity.x..rad.s.,Angular.velocity.y..rad.s.,"
       "Angular.velocity.z..rad.s.\n0,0,0,2\n.01,0,0,2\n"},
      {"odometry",
       "%time,field.header.stamp,field.pose.pose.orientation.x,"
       "field.pose.pose.orientation.y,field.pose.pose.orientation.z,"
       "field.pose.pose.orientation.w,field.twist.twist.angular.x,"
       "field.twist.twist.angular.y,field.twist.twist.angular.z\n"
       "1403636579768555392,1403636579758555392,0,0,0,1,0,0,2\n"
       "1403636579778555392,1403636579768555392,0,0,0,1,0,0,2\n",
       2, false},
      {"WitMotion",
       "StartTime: 2022-11-01 12:00:00.000\naddress\tTime(s)\tax(g)\tay(g)\taz(g)\twx(deg/s)\t"
       "wy(deg/s)\twz(deg/s)\tT(\xC2\xB0)\t\n0x50\t0\t0\t0\t1\t0\t0\t2\t25\t\n"
       "0x50\t.01\t0\t0\t1\t0\t0\t2\t25\t\n",
       2 * kDegree},
      {"ArduPilot",
       "TimeUS,I,GyrX (rad/s),GyrY (rad/s),GyrZ (rad/s),T\n0,0,0,0,2,40\n10000,0,0,0,2,40\n"},
      {"PASCO",
       "Time (s) Run #1,Angular Velocity - x (rad/s) Run #1,Angular Velocity - y (rad/s) Run #1,"
       "Angular Velocity - z (rad/s) Run #1\n0,0,0,2\n.01,0,0,2\n"},
      {"GoPro's",
       "t_ms,Gyroscope (z) [rad/s],Gyroscope (x) [rad/s],Gyroscope (y) [rad/s]\n"
       "0,2,0,0\n10,2,0,0\n"},
      {"Axivity", "Time (s),Gyro-X (d/s),Gyro-Y (d/s),Gyro-Z (d/s)\n0,0,0,2\n.01,0,0,2\n",
       2 * kDegree},
      {"OptiTrack",
       "Format Version,1.23,Take Name,Take 1,Export Frame Rate,100\n\n,,Rigid Body,Rigid Body,"
       "Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body\n,,Rotation,Rotation,"
       "Rotation,Rotation,Position,Position,Position,Mean Marker Error\nFrame,Time (Seconds),X,Y,Z,"
       "W,X,Y,Z,\n0,0,0,0,0,1,5,6,7,.1\n1,.01,0,0,0.00999983333,0.99995000042,5,6,7,.1\n",
       2, false},
      {"units below",
       "Time,Gyro X,Gyro Y,Gyro Z\n(s),(rad/s),(rad/s),(rad/s)\n0,0,0,2\n.01,0,0,2\n"},
  };
  return all;
}

TEST(Exporters, AreRead) {
  for (const Export& one : exports()) {
    const std::string problem = refusalOf([&] {
      const RecordedMotion motion = readRecording(one.text, "m.csv", {});
      EXPECT_NEAR(motion.duration(), 0.01, 1e-9) << one.program;
      const Eigen::Vector3d rate = motion.moments().front().angularVelocity;
      // Along the world's axes, y of which is the turned body's -z
      const Eigen::Vector3d expected(0, 0, one.isTurned ? -one.rate : one.rate);
      EXPECT_LT((rate - expected).norm(), 1e-6 * one.rate) << one.program << rate.transpose();
      EXPECT_EQ(motion.spins().source == SpinSource::Gyroscope, one.isAlone) << one.program;
    });
    EXPECT_EQ(problem, "") << one.program;
  }
}

TEST(Exporters, HaveForcesWithGravity) {
  for (const Export& one : exports()) {
    const bool has =
        one.text.find("ccel") != std::string::npos || one.text.find("Ac") != std::string::npos ||
        one.text.find("ACC") != std::string::npos || one.text.find("az_g") != std::string::npos ||
        one.text.find("az(g)") != std::string::npos;
    const InertialRecording recording = readInertial(one.text, "m.csv", {});
    EXPECT_EQ(recording.hasForce, has) << one.program;
    EXPECT_NEAR(recording.readings.front().force.norm(), has ? 9.8 : 0, 0.01) << one.program;
  }
  // phyphox's is without gravity.
  EXPECT_FALSE(readInertial("Time (s),wx (rad/s),wy (rad/s),wz (rad/s),Linear Acceleration x "
                            "(m/s^2),Linear Acceleration y (m/s^2),Linear Acceleration z (m/s^2)\n"
                            "0,0,0,2,0,0,0\n.01,0,0,2,0,0,0\n",
                            "m.csv", {})
                   .hasForce);
}

TEST(Exporters, AreReadInUtf16) {
  const std::string text =
      "Time (s)\tGyroskop x (\xC2\xB0/s)\tGyroskop y (\xC2\xB0/s)\t"
      "Gyroskop z (\xC2\xB0/s)\r\n0,0\t0\t0\t90\r\n0,5\t0\t0\t90\r\n";
  for (const bool isBigEndian : {false, true}) {
    std::string wide = isBigEndian ? "\xFE\xFF" : "\xFF\xFE";
    for (const char letter : text) {
      if (letter == '\xC2') continue;  // The degree sign is U+00B0.
      wide += isBigEndian ? std::string{'\0', letter} : std::string{letter, '\0'};
    }
    const RecordedMotion motion = readRecording(wide, "m.csv", {});
    EXPECT_EQ(motion.duration(), 0.5);
    EXPECT_EQ(motion.moments().front().angularVelocity.z(), 90 * kDegree);
    EXPECT_TRUE(contentsOf({wide, "m.csv"}, {}).hasRates);
  }
}

TEST(Columns, InTwoSpellingsAreRefused) {
  const auto refusalTo = [](const std::string& header, const ReadOptions& options = {}) {
    std::string row;
    for (const char letter : header) row += letter == ',' ? ",0" : "";
    return refusalOf(
        [&] { readRecording(header + "\n1" + row + "\n2" + row + "\n", "m.csv", options); });
  };
  const std::string twice =
      "t (s),wx (rad/s),wy (rad/s),wz (rad/s),gyro_x (rad/s),gyro_y (rad/s),gyro_z (rad/s)";
  EXPECT_EQ(
      refusalTo(twice),
      "m.csv: the columns 2 and 5, \"wx (rad/s)\" and \"gyro_x (rad/s)\", hold the same; name "
      "the one to take in simulation.columns, or with --column");
  EXPECT_EQ(refusalTo(twice, {.columns = {{"wx", "gyro_x (rad/s)"}}}), "");
  EXPECT_MESSAGE(refusalTo("t (s),wx (rad/s),wy (rad/s),wz (rad/s),Gyro Y (rad/s)"));
  EXPECT_MESSAGE(refusalTo("time (s),timestamp,wx (rad/s),wy (rad/s),wz (rad/s)"));
  EXPECT_EQ(refusalTo("time (s),timestamp,wx (rad/s),wy (rad/s),wz (rad/s)",
                      {.columns = {{"time", "time (s)"}}}),
            "");
  EXPECT_EQ(refusalTo("seconds_elapsed,time,wx (rad/s),wy (rad/s),wz (rad/s)"), "");
  EXPECT_MESSAGE(refusalTo("t (s),wx (rad/s),wy (rad/s),wz (rad/s),ax,ay,az,acc_x,acc_y,acc_z"));
  // Physics Toolbox's gFx is the specific force, ax without gravity.
  EXPECT_EQ(refusalTo("t (s),wx (rad/s),wy (rad/s),wz (rad/s),ax,ay,az,gFx,gFy,gFz"), "");
  const std::string both = "t (s),qw,qx,qy,qz,r11,r12,r13,r21,r22,r23,r31,r32,r33";
  EXPECT_MESSAGE(refusalTo(both));
  EXPECT_MESSAGE(refusalTo(both, {.columns = {{"qw", "qw"}}}));
  EXPECT_MESSAGE(refusalTo("t (s),qw,qx,qy,qz,quat_w,quat_x,quat_y,quat_z"));
  // A matrix, whose order isn't said.
  EXPECT_MESSAGE(refusalTo("t (s),Rot[0],Rot[1],Rot[2],Rot[3],Rot[4],Rot[5],Rot[6],Rot[7],Rot[8]"));
  // Which of these is w isn't said.
  EXPECT_MESSAGE(refusalTo("t (s),q1,q2,q3,q4"));
}

/// Returns the largest error of the steps of a recording with rows at these times. [s]
double errorOfSteps(const std::string& time, const std::vector<std::string>& times, double step) {
  std::string text = time + ",wx (rad/s),wy (rad/s),wz (rad/s)\n";
  for (const std::string& one : times) text += one + ",0,0,2\n";
  double error = 0;
  const auto take = [&](double before, double after) {
    error = std::max(error, std::abs(after - before - step));
  };
  const auto moments = readRecording(text, "m.csv", {}).moments();
  const auto readings = readInertial(text, "m.csv", {}).readings;
  for (std::size_t i = 1; i < times.size(); ++i) {
    take(moments[i - 1].time, moments[i].time);
    take(readings[i - 1].rate.time, readings[i].rate.time);
  }
  return error;
}

TEST(Times, OfCalendarsKeepAllDigits) {
  for (const long long step : {1'000'000LL, 5'000'000LL}) {  // 1 kHz and 200 Hz [ns]
    std::vector<std::string> nanoseconds, seconds, powers, microseconds;
    for (int i = 0; i < 50; ++i) {
      const long long time = 1'727'600'000'123'456'789 + i * step;
      const std::string text = std::to_string(time);
      nanoseconds.push_back(text);
      seconds.push_back(text.substr(0, 10) + "." + text.substr(10));
      powers.push_back(text.substr(0, 1) + "." + text.substr(1) + "e+18");
      microseconds.push_back(text.substr(0, 16) + "." + text.substr(16));
    }
    const double expected = 1e-9 * static_cast<double>(step);
    // measured 5.1e-17 s; doubles of such times are 2.4e-7 s apart, or 256 ns
    EXPECT_LT(errorOfSteps("t_ns", nanoseconds, expected), 1e-15);
    EXPECT_LT(errorOfSteps("t (s)", seconds, expected), 1e-15);
    EXPECT_LT(errorOfSteps("timestamp [ns]", powers, expected), 1e-15);
    EXPECT_LT(errorOfSteps("t_us", microseconds, expected), 1e-15);
  }
}

TEST(Times, OfCalendarsAreThoseOfTheFile) {
  std::string text = "timestamp [ns],wx (rad/s),wy (rad/s),wz (rad/s)\n";
  for (int i = 0; i < 20; ++i)
    text += std::to_string(1'727'600'000'000'000'000 + i * 10'000'000LL) + ",0,0,2\n";
  const RecordedMotion motion =
      readRecording(text, "m.csv", {.from = 1'727'600'000.05, .to = 1'727'600'000.19});
  EXPECT_NEAR(motion.duration(), 0.14, 3e-7);  // Of which doubles resolve 2.4e-7.
  EXPECT_EQ(readInertial(text, "m.csv", {}).zero, 1'727'600'000);
  EXPECT_MESSAGE(refusalOf([&] { readRecording(text, "m.csv", {.from = 1'727'600'001}); }));
}

}  // namespace
}  // namespace rotatebook::recording
