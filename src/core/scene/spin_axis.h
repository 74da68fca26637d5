// Spins that are stated by the rank of a moment. Inside the room only.
#pragma once

#include "scene/scene.h"

namespace rotatebook::scene {

/// Gives a spin that names its axis the direction of that axis of the motion's body.
void turnSpinToAxis(Motion& motion);

/// Likewise of any spin, once the motion has its particles. Throws InputError if the axis isn't
/// unique, or its tilt is along it.
void settleSpin(Motion& motion);

}  // namespace rotatebook::scene
