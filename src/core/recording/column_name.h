// The name of a column, taken apart. Inside the room only.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rotatebook::recording {

/// The parts of a column's header.
struct ColumnName {
  /// The words in one, with numbers in brackets, but without units, and without what programs write
  /// before all names: "gyroscopex" for "Gyroscope x (rad/s)", "gyrox" for "gyro_x_dps",
  /// "angularvelocityx" for "field.angular_velocity.x", "gyro0" for "gyro_rad[0]".
  std::string plain;
  /// Of brackets, without blanks, "rad/s", or of rates and accelerations at the name's end, before
  /// an axis or after it: "dps"; empty without.
  std::string unit;
  std::vector<std::string> words;  ///< Outside brackets: "time", "ms" for "timeMs". Small letters.
};

ColumnName columnNameOf(std::string_view header);

/// Returns whether a column is called as the angular velocity of ROS's messages is, which is along
/// the body's axes and in rad/s: "angular_velocity.x", "/imu/angular_velocity/x".
bool isOfRos(std::string_view header);

}  // namespace rotatebook::recording
