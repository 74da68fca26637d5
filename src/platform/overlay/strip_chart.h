// Charts over the time of the clip. Inside the room only.
#pragma once

#include <memory>

#include "overlay/drawn_overlay.h"

namespace rotatebook::overlay {

/// Returns where the energy chart of this motion alone ends, as a share of the initial total
/// energy.
double energyTop(const physics::Trajectory& trajectory);

/// Makes a chart of the kinetic, spring and total energy as shares of the initial total, from 0 to
/// energyTop() or OverlayContext::energyTop, whichever is higher.
std::unique_ptr<DrawnOverlay> makeEnergyChart(const OverlayContext& context, const Box& box);
/// Makes a chart of the angle to the exact motion.
std::unique_ptr<DrawnOverlay> makeErrorChart(const OverlayContext& context, const Box& box);

}  // namespace rotatebook::overlay
