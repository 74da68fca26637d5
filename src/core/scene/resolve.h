// From the Spec of a scene to all that follows. Inside the room only.
#pragma once

#include "base/document/value_reader.h"
#include "scene/body_section.h"
#include "scene/scene.h"

namespace rotatebook::scene {

/// Finds what follows from `spec`: motions with the bodies, particles and starts that they have,
/// those of a grid's cells and of a study's runs, and the camera's default place. `file` is what it
/// was read from: values that are varied are read in its place, and messages give its locations.
/// Throws InputError.
Scene resolve(Spec spec, const document::ValueReader& file, const MeshFiles& meshes);

}  // namespace rotatebook::scene
