// The camera of a scene.
#pragma once

#include "geometry/camera.h"
#include "scene/scene.h"

namespace rotatebook::timeline {

/// Returns the scene's camera for `screen`, the whole picture or a panel, at the distance that the
/// scene states.
geometry::Camera cameraOf(const scene::Scene& scene, const geometry::Screen& screen);

}  // namespace rotatebook::timeline
