// Meshes, as a page draws them. Inside the room only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "geometry/book_mesh.h"
#include "scene/scene.h"

namespace rotatebook::bridge {

/// Numbers of each vertex.
inline constexpr std::size_t kVertexFloats = 13;

/// The book's mesh: vertices as kVertexFloats each, and the indices of each part.
struct BookMesh {
  std::vector<float> vertices;
  std::array<std::vector<std::uint16_t>, geometry::kBookPartCount> indices;
};

/// Returns the mesh of the unit book, made once.
const BookMesh& bookMesh();

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
