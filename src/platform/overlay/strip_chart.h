// Charts over the time of the clip. Inside the room only.
#pragma once

#include "overlay/drawn_overlay.h"

namespace rotatebook::overlay {

/// Returns where the energy chart of this motion alone ends, as a share of the initial total
/// energy.
double energyTop(const physics::Trajectory& trajectory);

}  // namespace rotatebook::overlay
