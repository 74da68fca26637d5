// A motion's body, as a page draws it. Inside the room only.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "scene/scene.h"

namespace rotatebook::bridge {

/// Returns the vertices as 10 floats each, as bridge.h says.
std::vector<float> floatsOf(const std::vector<geometry::MeshVertex>& vertices);

/// A body's triangles, by material.
struct BodyMesh {
  std::string json;  ///< As bridge.h says.
  std::vector<float> vertices;
  std::vector<std::uint32_t> indices;
};

/// Returns the mesh of a body that isn't the book. `fileOf` returns the bytes of a mesh's file;
/// null if it isn't here: a box of the body's size takes its place. A file's pictures aren't shown.
/// Throws InputError for a file of more than body::kMaxDrawnTriangles.
BodyMesh bodyMeshOf(const scene::Motion& motion,
                    const std::function<const std::string*(const std::string&)>& fileOf);

}  // namespace rotatebook::bridge
