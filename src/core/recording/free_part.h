// The parts of a recording that are free motions. Inside the room only.
#pragma once

#include <vector>

#include "recording/throws.h"

namespace rotatebook::recording {

/// A fast stretch, and what is free motion of it.
struct FreeStretch {
  FastStretch stretch;
  Range part;  ///< Of a flight, the readings that one free motion fits; else the stretch.
};

/// Returns the stretches of a recording by fits. From the middle half of each flight its part grows
/// within the fast readings around it, as far as the free motion that is fitted leads to what is
/// read, within six times the noise at rest or what the fit leaves: a hand's readings that pass
/// into a flight smoothly are left out, and a flight of which a half was found is whole. Stretches
/// whose middle is in a longer one's part are left out.
std::vector<FreeStretch> freeStretches(const InertialRecording& recording);

}  // namespace rotatebook::recording
