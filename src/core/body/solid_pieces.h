// Closed surfaces of which shapes are made. Inside the room only.
#pragma once

#include <span>

#include <Eigen/Core>

#include "body/triangle_mesh.h"

namespace rotatebook::body {

/// Sides of what is round. An even number.
inline constexpr int kSides = 128;

/// Returns a cuboid around the origin. [m]
TriangleMesh cuboidOf(const Eigen::Vector3d& size);

/// Returns a convex or star-shaped outline in the plane x y, counter-clockwise and around the
/// origin, as a prism of that height around z = 0. [m]
TriangleMesh prismOf(std::span<const Eigen::Vector2d> outline, double height);

/// Returns an outline of (distance from the axis, height), turned round the axis z in kSides steps;
/// counter-clockwise, distance to the right. [m] Where the distance is 0, the outline may begin and
/// end; else it is a closed one. Distances grow by sqrt(x / sin x), x = 2 pi / kSides, so that the
/// volume is exactly the round body's, and moments agree to x^4 / 180 = 3e-8.
TriangleMesh turnedRound(std::span<const Eigen::Vector2d> outline);

/// Returns a cylinder around the axis z and around the origin. [m]
TriangleMesh cylinderOf(double radius, double height);
/// Returns a ring around the axis z with a round section. [m]
TriangleMesh ringOf(double radius, double sectionRadius);
/// Returns an ellipsoid of these diameters around the origin, of the exact volume. [m]
TriangleMesh ellipsoidOf(const Eigen::Vector3d& size);

/// Adds a surface, moved by `place`. [m]
void addMoved(const TriangleMesh& piece, const Eigen::Vector3d& place, TriangleMesh& into);
/// Returns the surface turned by thirds, so that its axis z becomes x (1) or y (2).
TriangleMesh alongAxis(TriangleMesh piece, int thirds);

}  // namespace rotatebook::body
