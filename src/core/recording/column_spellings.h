// Usual names of columns, as programs and phones write them. Inside the room only.
#pragma once

#include <array>
#include <string_view>

namespace rotatebook::recording {

/// Usual names of times, in the order of preference. They are compared with ColumnName::plain.
inline constexpr std::string_view kTimeNames =
    "secondselapsed elapsed elapsedtime timesincestart stamp stampsecs stampsec timestampshimmer "
    "timestampsyncunix motiontimestampsincereboot gyrotimestampsincereboot "
    "accelerometertimestampsincereboot time t times ts timestamp timestampunix "
    "timestampformattedunix unixtime epoch epoc sampletimefine seconds millis micros ms "
    "us zeit temps tiempo tempo tijd";
/// Names that are taken where there are others beside them: times since the start, and those of a
/// message or sensor itself.
inline constexpr std::string_view kPreferredTimes =
    "secondselapsed elapsed elapsedtime timesincestart stamp stampsecs stampsec timestampshimmer "
    "timestampsyncunix motiontimestampsincereboot gyrotimestampsincereboot";
/// ROS's nanoseconds beside seconds.
inline constexpr std::string_view kNanosecondNames = "stampnsecs stampnsec stampnanosec";

/// A group of columns, and their usual names: a beginning and an end, as in ColumnName::plain.
struct Spellings {
  std::string_view roles;       ///< Of columns, separated by blanks, as are the others.
  std::string_view beginnings;  ///< Words before an end; or behind it, if longer than two letters.
  std::string_view preferred;   ///< Beginnings that are taken where there are others, too.
  std::string_view loose;       ///< Beginnings of other things, too, such as angles.
  std::array<std::string_view, 3> ends;  ///< In the order of the roles; the first is usual.
};

// The last beginning of quaternions is none: single letters, beside the three others alone. Xsens's
// "Quat_q0" and PX4's "q[0]" have w first.
inline constexpr Spellings kQuaternions{
    "qw qx qy qz",
    "q quat quaternion motionquaternion quatq orientation attitude rotation rot qrs ",
    "",
    "orientation attitude rotation rot",
    {"w x y z", "0 1 2 3", ""}};
inline constexpr Spellings kMatrices{
    "r11 r12 r13 r21 r22 r23 r31 r32 r33",
    "r m rot mat matrix rotationmatrix",
    "",
    "",
    {"11 12 13 21 22 23 31 32 33", "00 01 02 10 11 12 20 21 22", ""}};
inline constexpr Spellings kRates{
    "wx wy wz",
    "w \xCF\x89 g gy gyr gyro gyros gyroscope gyrorotation gyroadc gyrodata omega angularvelocity "
    "angvel "
    "angular rate rotationrate motionrotationrate angularrate wrss gyroskop giroscopio "
    "giroscop\xC3\xB3pio "
    "gyroscoop",
    "",
    "",
    {"x y z", "0 1 2", "1 2 3"}};
// Physics Toolbox's gFx is the specific force beside ax without gravity; Shimmer has accelerometers
// of low noise and of wide range.
inline constexpr Spellings kAccelerations{
    "ax ay az",
    "gf accelerationwithg accelln lownoiseaccelerometer a ac acc accel acceleration accelerometer "
    "specificforce "
    "arss accelerationincludinggravity accelerometeracceleration accelwr "
    "widerangeaccelerometer "
    "beschleunigung acc\xC3\xA9l\xC3\xA9ration aceleraci\xC3\xB3n accelerazione versnelling",
    "gf accelerationwithg accelln lownoiseaccelerometer",
    "",
    {"x y z", "0 1 2", "1 2 3"}};

}  // namespace rotatebook::recording
