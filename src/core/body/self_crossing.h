// A search for a surface that passes through itself.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "body/triangle_mesh.h"

namespace rotatebook::body {

/// Returns two triangles of a welded, closed mesh that cross each other; nothing if none are found.
/// An edge of one passes through the other, beyond doubt by the error of its determinants: where
/// triangles touch, or lie in one plane, they don't cross. Takes 0.3 s for 200,000 triangles, and
/// time in proportion but for a logarithm; where very many lie on one another, it gives up early.
std::optional<std::array<std::size_t, 2>> findSelfCrossing(const TriangleMesh& mesh);

}  // namespace rotatebook::body
