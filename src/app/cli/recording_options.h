// Options of the commands that read recordings. Inside the room only.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "recording/read_recording.h"

namespace rotatebook::cli {

/// The values of --rates, --time-unit, --column, --from and --to.
struct RecordingOptions {
  recording::ReadOptions options;
  std::vector<std::string> columns;  ///< "wx=NAME"

  void addTo(CLI::App& command);
  /// Returns the options. Throws InputError for a column that isn't HOLDS=NAME.
  recording::ReadOptions read() const;
};

/// Returns the problem of an option's number that isn't 0 or more; empty if there is none.
std::string notNegative(const std::string& text);

/// Returns three numbers over 0, such as "0.004,0.002,0.005". Throws InputError that names
/// `option`.
Eigen::Vector3d threeNumbers(const std::string& text, const char* option);

}  // namespace rotatebook::cli
