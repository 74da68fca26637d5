// Limits of control groups: those of containers, batch systems and services. Inside the room only.
#pragma once

#include <filesystem>
#include <optional>

namespace rotatebook::system {

/// The lowest limits among this process's control groups and those above them; nothing where there
/// is no limit.
struct ControlGroupLimits {
  std::optional<double> cores{};   ///< Processor time in a unit of time, > 0.
  std::optional<double> memory{};  ///< [bytes]
};

/// Reads the limits from control groups of version 2 and 1; `root` has the folder proc/, and the
/// folders that proc/self/mountinfo names. Files that can't be read set no limit.
ControlGroupLimits controlGroupLimits(const std::filesystem::path& root = "/");

}  // namespace rotatebook::system
