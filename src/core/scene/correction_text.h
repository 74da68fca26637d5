// The corrections of a motion in words.
#pragma once

#include <string>
#include <vector>

#include "physics/motion_settings.h"
#include "scene/words.h"

namespace rotatebook::scene {

/// Lists how a motion in steps undoes the integrator's drift: "normalised", "not normalised" or
/// "normalised every 100 steps"; for particles whose remedies differ, each of them.
std::vector<std::string> correctionTexts(const physics::SimulationSettings& settings,
                                         const Words& words = {});

}  // namespace rotatebook::scene
