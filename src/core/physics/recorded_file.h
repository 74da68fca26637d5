// A recording that a motion is taken from.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace rotatebook::recording {
class RecordedMotion;
}

namespace rotatebook::physics {

/// The file that Model::Recorded takes its motion from. Who opens files reads it into `motion`.
struct RecordedFile {
  std::string file{};  ///< Relative to the scene's folder; empty for other models.
  /// recording::ReadOptions::columns
  std::vector<std::pair<std::string, std::string>> columns{};
  std::string rates{};                 ///< recording::ReadOptions::unit
  std::string ratesAlong{};            ///< recording::ReadOptions::ratesAlong
  std::string timeUnit{};              ///< recording::ReadOptions::timeUnit
  std::optional<double> from{}, to{};  ///< The part to take, of the file's times. [s]
  Eigen::Vector3d bias{0, 0, 0};       ///< recording::ReadOptions::bias [rad/s]
  std::string checksum{};              ///< checksumOf() the file's bytes; empty if not known.
  std::shared_ptr<const recording::RecordedMotion> motion{};  ///< Null until it is read.

  /// Compares all but the motion, which follows from the rest.
  friend bool operator==(const RecordedFile& a, const RecordedFile& b) {
    return a.file == b.file && a.columns == b.columns && a.rates == b.rates &&
           a.ratesAlong == b.ratesAlong && a.timeUnit == b.timeUnit && a.from == b.from &&
           a.to == b.to && a.bias == b.bias && a.checksum == b.checksum;
  }
};

}  // namespace rotatebook::physics
