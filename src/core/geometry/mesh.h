// A body's surface as a mesh in the unit cube of its deformation cage.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace rotatebook::geometry {

/// The highest MeshVertex::surfaceId.
inline constexpr int kMaxSurfaceId = 243;

/// A vertex, laid out as body.vert reads it.
struct MeshVertex {
  Eigen::Vector3f position;  ///< In the unit cube.
  /// Outward, as a covector of the cube: the cofactors of the map to the world turn it into the
  /// world's normal. Of unit length.
  Eigen::Vector3f normal;
  Eigen::Vector2f texCoord;  ///< v points up.
  float skyVisibility = 1;   ///< Share of the surroundings that lights this position. [0 to 1]
  /// Number of the smooth side it belongs to, 1 to kMaxSurfaceId; a triangle has that of its last
  /// vertex.
  float surfaceId = 0;
  /// Covector away from what hides the rest of the surroundings from here, which it gets light of;
  /// as long as the rest's share.
  Eigen::Vector3f away{0, 0, 0};
};

/// A row of squares of a part's roundings, rims or hinges. It is seldom wider than a pixel, and
/// light changes much from one strip to the next.
struct MeshStrip {
  std::size_t part = 0;            ///< Index of its part.
  float length = 0;                ///< In heights of the body, up to 1.
  bool flat = true;                ///< True if its normals are equal on both sides.
  std::vector<MeshVertex> middle;  ///< The middle line, from end to end.
  /// Both side lines at the squares' ends, in the unit cube, from end to end;
  /// (sides[0][0], sides[0][1], sides[1][0]) has the triangles' winding.
  std::array<std::vector<Eigen::Vector3f>, 2> sides;
};

inline constexpr std::uint8_t kNoStrip = 255;

/// Triangles that share a texture; each part takes one draw call.
struct MeshPart {
  /// Vertex indices, three per triangle, counter-clockwise from outside.
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint8_t> stripOf;  ///< Index of each triangle's strip, or kNoStrip.
  /// True if other parts hide it, unless the body is deformed out of all shape.
  bool hidden = false;
  std::size_t alike = 0;  ///< Index of the first part of the same material.
};

/// A mesh of triangles, grouped by part.
struct Mesh {
  std::vector<MeshVertex> vertices;
  std::vector<MeshPart> parts;
  std::vector<MeshStrip> strips;
};

/// Returns the weights of the cage's corners at a position in the unit cube. Their sum is 1.
inline Eigen::Matrix<double, 8, 1> trilinearWeights(const Eigen::Vector3f& unitPosition) {
  Eigen::Matrix<double, 8, 1> weights;
  for (int i = 0; i < 8; ++i) {
    weights[i] = 1;
    for (int axis = 0; axis < 3; ++axis) {
      weights[i] *= (i & (1 << axis)) != 0 ? unitPosition[axis] : 1 - unitPosition[axis];
    }
  }
  return weights;
}

}  // namespace rotatebook::geometry
