// The checksum of a clip's motions.
#pragma once

#include <string>

#include "timeline/clip_motion.h"

namespace rotatebook::timeline {

/// Returns checksumOf() the bits of a clip's motions, one after the other: their number of samples
/// (64-bit integer), interval, time of divergence (-1 if there is none), and for each sample the
/// time, attitude (w, x, y, z), angular velocity, angular momentum, kinetic and potential energy,
/// half-turns (64-bit integer) and corners (x, y, z of each). Numbers are IEEE doubles unless
/// stated otherwise; each has 8 bytes, the lowest first.
///
/// The pictures depend on nothing else in a motion. Quantities that follow from these are left out:
/// tilt, stretch, error, regime and rotational energy.
std::string motionChecksum(const ClipMotion& motion);

}  // namespace rotatebook::timeline
