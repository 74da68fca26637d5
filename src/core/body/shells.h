// The connected surfaces of a mesh.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "body/triangle_mesh.h"

namespace rotatebook::body {

/// The connected surfaces of a closed mesh.
struct Shells {
  std::size_t count = 0;
  /// Two triangles at an edge around which something is enclosed twice, or taken away where nothing
  /// is; nothing if there is no such edge.
  std::optional<std::array<std::size_t, 2>> overlap{};
};

/// Finds the connected surfaces of a mesh that requireClosed() accepts. Where more than two
/// triangles share an edge, those are connected that have the body between them: bodies that touch
/// along an edge, in a corner or with a face each are surfaces of their own.
Shells shellsOf(const TriangleMesh& mesh);

}  // namespace rotatebook::body
