// A motion as a table.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "physics/trajectory.h"
#include "pipeline/clip_motion.h"

namespace rotatebook::pipeline {

/// One row a frame under a header row: frame, time_s, attitude quaternion (qw to qz), angular
/// velocity (w) and momentum (L) in world axes, energies, tilt_deg, half_turns, stretch_min,
/// stretch_max and the eight drawn corners (c0x to c7z); then error_deg, the angle to the exact
/// attitude, energy_ratio and L_ratio, each to its start, and regime (1, 0 or -1, as Regime). SI
/// units; numbers read back to the same bits.
std::string trajectoryCsv(const physics::Trajectory& trajectory);

/// Writes the table of each motion to the file of the same place in `files`. Throws MachineError.
void writeTables(const std::vector<std::filesystem::path>& files, const ClipMotion& motion);

}  // namespace rotatebook::pipeline
