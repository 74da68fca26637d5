// A test of a mesh: is it the surface of a body?
#pragma once

#include <cstddef>

#include "body/triangle_mesh.h"

namespace rotatebook::body {

/// Throws InputError, naming the triangle or the edge and the remedy, unless the welded mesh
/// encloses a body: it has triangles, no triangle has a corner twice, and every edge belongs to two
/// triangles that run along it in opposite directions. Takes time in proportion to the triangles.
void requireClosed(const TriangleMesh& mesh);

/// Returns the number of a mesh's connected surfaces. What lies inside two of them counts twice.
std::size_t countShells(const TriangleMesh& mesh);

}  // namespace rotatebook::body
