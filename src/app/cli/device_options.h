// Options that every command that draws takes. Inside the room only.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "render/device/device.h"

namespace rotatebook::cli {

/// --device and --require-hardware.
struct DeviceOptions {
  std::string device;  ///< "N", "cuda:N", "software" or empty.
  bool requireHardware = false;

  void addTo(CLI::App& command);
  /// What they mean, with a warning that is printed once. Throws InputError.
  render::DeviceChoice choice() const;
};

}  // namespace rotatebook::cli
