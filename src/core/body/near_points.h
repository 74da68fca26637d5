// Points of a mesh that are meant to be one. Inside the room only.
#pragma once

#include <cstddef>

#include "body/triangle_mesh.h"

namespace rotatebook::body {

/// Points nearer to each other than this are one, where a mesh isn't closed without. [of the mesh's
/// longest side]
inline constexpr double kNearPoints = 1e-9;

/// The points that were joined.
struct JoinedPoints {
  std::size_t count = 0;  ///< Points that became another one.
  double distance = 0;    ///< The largest between two that became one. [the mesh's unit]
};

/// Gives triangles the same point where they have points that are nearer to each other than
/// kNearPoints: the first of these, in the order of the points. All become one with that first
/// point, so that a chain of points doesn't creep together. Takes time in proportion to the points.
JoinedPoints joinNearPoints(TriangleMesh& mesh);

}  // namespace rotatebook::body
