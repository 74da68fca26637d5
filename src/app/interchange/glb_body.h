// Bodies with their looks in a .glb file. Inside the room only.
#pragma once

#include <cstddef>

#include "interchange/glb_file.h"
#include "scene/scene.h"

namespace rotatebook::interchange {

/// Adds the body of the scene's only motion as a mesh around its centre of mass, in metres, with
/// its materials and pictures, all of it bound to the first joint of a skin; returns its number
/// among "meshes". Throws as picture::loadLooks() does.
std::size_t addBody(const scene::Scene& scene, GlbFile& glb);

}  // namespace rotatebook::interchange
