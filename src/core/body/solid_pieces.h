// Solids of which shapes are made. Inside the room only.
#pragma once

#include <span>

#include <Eigen/Core>

#include "body/solid_piece.h"

namespace rotatebook::body {

/// Sides of the surface of what is round, an even number. It has exactly the round volume.
inline constexpr int kSides = 128;

/// Returns a cuboid around the origin. [m]
SolidPiece cuboidOf(const Eigen::Vector3d& size);

/// Returns a convex or star-shaped outline in the plane x y, counter-clockwise and around the
/// origin, as a prism of that height around z = 0. [m]
SolidPiece prismOf(std::span<const Eigen::Vector2d> outline, double height);

/// Returns point `i` of a circle of radius 1, exactly mirrored in both axes; `sides` is a multiple
/// of 4.
Eigen::Vector2d onCircle(int i, int sides);

/// Returns an outline of (distance from the axis, height), turned round the axis z in `sides`
/// steps; counter-clockwise, distance to the right. [m] Where the distance is 0, the outline may
/// begin and end; else it is a closed one. Distances grow by sqrt(x / sin x), x = 2 pi / `sides`,
/// so that the volume is exactly the round body's.
TriangleMesh turnedRound(std::span<const Eigen::Vector2d> outline, int sides = kSides);

/// Returns a cylinder around the axis z and around the origin. [m]
SolidPiece cylinderOf(double radius, double height);
/// Returns a cylinder like that, with a bore along its axis. [m]
SolidPiece tubeOf(double radius, double bore, double height);
/// Returns a ring around the axis z with a round section. [m]
SolidPiece ringOf(double radius, double sectionRadius);
/// Returns an ellipsoid of these diameters around the origin. [m] `sides` is a multiple of 4.
SolidPiece ellipsoidOf(const Eigen::Vector3d& size, int sides = kSides);

/// Adds a solid, moved by `place`. [m]
void addMoved(const SolidPiece& piece, const Eigen::Vector3d& place, SolidPiece& into);
/// Return a solid or a surface turned by thirds, so that its axis z becomes x (1) or y (2).
SolidPiece alongAxis(SolidPiece piece, int thirds);
TriangleMesh alongAxis(TriangleMesh mesh, int thirds);

}  // namespace rotatebook::body
