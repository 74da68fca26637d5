// Options of the commands that draw. Inside the room only.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "render/device/device.h"

namespace rotatebook::cli {

/// The values of --device and --require-hardware.
struct DeviceOptions {
  std::string device;  ///< "N", "cuda:N", "software" or empty.
  bool requireHardware = false;

  void addTo(CLI::App& command);
  /// Returns the choice that they make; its warning is printed once. Throws InputError.
  render::DeviceChoice choice() const;
};

}  // namespace rotatebook::cli
