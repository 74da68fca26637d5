// Polygons as triangles. Inside the room only.
#pragma once

#include <cstdint>
#include <span>

#include "body/triangle_mesh.h"

namespace rotatebook::meshes {

/// Adds a polygon as triangles: a fan of a convex one, else ear by ear; one that crosses itself as
/// well as it goes. Throws InputError if there would be too many triangles, or if it isn't convex
/// and has more than 1000 corners.
void addPolygon(std::span<const std::uint32_t> corners, body::TriangleMesh& mesh);

/// Throw InputError if a mesh of so many triangles, or of so many points, is too large.
void requireFewTriangles(std::size_t count);
void requireFewPoints(std::size_t count);

}  // namespace rotatebook::meshes
