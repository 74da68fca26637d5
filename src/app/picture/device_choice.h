// The choice of what draws: who has scenes drawn hands it on, and needs to know no more of
// renderers.
#pragma once

#include "render/device/device.h"

namespace rotatebook::picture {

using render::DeviceChoice;
using render::isSoftwareRenderer;

}  // namespace rotatebook::picture
