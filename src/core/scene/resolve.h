// From the Spec of a scene to all that follows. Inside the room only.
#pragma once

#include "scene/body_section.h"
#include "scene/scene.h"

namespace rotatebook::scene {

/// Finds what follows from `spec`: the bodies, particles and starts that its motions and runs have,
/// and the camera's default place. Throws InputError with the locations of `spec`.
Scene resolve(Spec spec, const MeshFiles& meshes);

}  // namespace rotatebook::scene
