// Bodies with their looks in a .glb file. Inside the room only.
#pragma once

#include <cstddef>
#include <optional>

#include "picture/interchange/exported_body.h"
#include "picture/interchange/glb_file.h"

namespace rotatebook::interchange {

/// Adds a body as a mesh, with its materials and pictures, all of it bound to the first joint of a
/// skin; returns its number among "meshes". With `reach` > 0 [m] each corner of the box around it
/// has three morph targets, which move it along x, y and z: by -reach at weight 0, by reach at 1,
/// as Blender and others allow no weights beyond. All of the body is trilinear in the corners, so
/// that its shapes are exact. Normals follow small displacements.
std::size_t addBody(const ExportedBody& body, std::optional<double> reach, GlbFile& glb);

}  // namespace rotatebook::interchange
