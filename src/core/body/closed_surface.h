// A test of a mesh: is it the surface of a body? Inside the room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "body/triangle_mesh.h"

namespace rotatebook::body {

/// Returns whether the welded mesh encloses a body: it has triangles, none of them has a corner
/// twice, as many of them run along each edge in one direction as in the other, no two are the
/// same, and not each has its reverse. Its integrals are then well defined, also where bodies touch
/// along an edge or a face.
bool isClosed(const TriangleMesh& mesh);

/// Throws InputError unless isClosed(), naming the triangle or the edge and the remedy. `numbers`:
/// of the triangles in their file, from 0; empty if they have their own. Takes time in proportion
/// to the triangles.
void requireClosed(const TriangleMesh& mesh, std::span<const std::uint32_t> numbers = {});

}  // namespace rotatebook::body
