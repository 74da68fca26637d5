// Options of the commands that draw. Inside the room only.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "picture/device_choice.h"

namespace rotatebook::cli {

/// The values of --device and --require-hardware.
struct DeviceOptions {
  std::string device;  ///< "N", "cuda:N", "software" or empty.
  bool requireHardware = false;

  void addTo(CLI::App& command);
  /// Returns the words of a command line with these options.
  std::vector<std::string> words() const;
  /// Returns the choice that they make. Throws InputError.
  picture::DeviceChoice parsed() const;
  /// Returns parsed(), for drawing with it: its warning is printed once, and from now on a crash of
  /// this process starts the command `after-crash` in its place, which advises --resume if the
  /// command is `resumable`.
  picture::DeviceChoice choice(bool resumable = false) const;
};

}  // namespace rotatebook::cli
