// A motion as a CSV table.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "physics/trajectory.h"

namespace rotatebook::timeline {

/// Returns a header row and one row a frame: frame, time_s, attitude quaternion (qw to qz), angular
/// velocity (w) and momentum (L) in world axes, energies, tilt_deg, half_turns, stretch_min,
/// stretch_max and the eight drawn corners (c0x to c7z); then error_deg, the angle to the exact
/// attitude, energy_ratio and L_ratio, each relative to the start, and regime (1, 0 or -1, as
/// Regime). SI units; numbers read back to the same bits.
std::string trajectoryCsv(const physics::Trajectory& trajectory);

/// Passes the same table to `take` in pieces of some 64 KiB.
void writeCsv(const physics::Trajectory& trajectory,
              const std::function<void(std::string_view)>& take);

}  // namespace rotatebook::timeline
