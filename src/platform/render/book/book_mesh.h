// The book's surface as a mesh in the unit cube of its deformation cage. Inside the room only.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace rotatebook::render {

/// Surfaces that share a texture; each takes one draw call.
enum class BookPart {
  Front,
  Spine,
  Back,
  Pages,
  Lining,  ///< The case's inner sides that the leaves hide, unless the book is deformed out of all
           ///< shape.
};

inline constexpr std::size_t kBookPartCount = 5;

/// The highest BookVertex::surfaceId.
inline constexpr int kMaxSurfaceId = 18;

/// A vertex, laid out as book.vert reads it.
struct BookVertex {
  /// In the unit cube: spine to fore edge, foot to head, back to front cover.
  Eigen::Vector3f position;
  /// Outward, as a covector of the cube: the cofactors of the map to the world turn it into the
  /// world's normal. Of unit length.
  Eigen::Vector3f normal;
  Eigen::Vector2f texCoord;  ///< v points up.
  float skyVisibility = 1;   ///< Share of the surroundings that lights this position. [0 to 1]
  float surfaceId = 0;       ///< Number of the smooth side it belongs to, 1 to kMaxSurfaceId.
};

/// A row of squares of a part's roundings, rims or hinges. It is seldom wider than a pixel, and
/// light changes much from one strip to the next.
struct BookStrip {
  BookPart part = BookPart::Front;
  float length = 0;                ///< In heights of the book, up to 1.
  bool flat = true;                ///< True if its normals are equal on both sides.
  std::vector<BookVertex> middle;  ///< The middle line, from end to end.
  /// Both side lines at the squares' ends, in the unit cube, from end to end;
  /// (sides[0][0], sides[0][1], sides[1][0]) has the triangles' winding.
  std::array<std::vector<Eigen::Vector3f>, 2> sides;
};

/// A mesh of triangles, grouped by part.
struct BookMesh {
  std::vector<BookVertex> vertices;
  /// Vertex indices by BookPart, three per triangle, counter-clockwise from outside.
  std::array<std::vector<std::uint32_t>, kBookPartCount> triangles;
  std::vector<BookStrip> strips;
  /// Index of each triangle's strip, or kNoStrip, by BookPart.
  std::array<std::vector<std::uint8_t>, kBookPartCount> stripOf;
};

inline constexpr std::uint8_t kNoStrip = 255;

/// Returns the weights of the cage's corners at a position in the unit cube. Their sum is 1.
Eigen::Matrix<double, 8, 1> trilinearWeights(const Eigen::Vector3f& unitPosition);

/// Makes a hardback with a rounded spine, hinges, and boards with rounded edges that overlap a page
/// block with a hollow fore edge. Sides are grids, so that one whose corners leave their plane is
/// still textured without a crease.
BookMesh makeBookMesh();

}  // namespace rotatebook::render
