// The keys of [simulation] that say where a recorded motion is. Inside the room only.
#pragma once

#include "scene/keys/key.h"
#include "scene/scene.h"

namespace rotatebook::scene {

Keys<physics::SimulationSettings> recordedKeys();

}  // namespace rotatebook::scene
