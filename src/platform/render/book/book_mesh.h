// The book's surface, in the unit cube that its eight corners span. Inside the room only.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace rotatebook::render {

/// Surfaces that share a texture; each is one draw call.
enum class BookPart {
  Front,
  Spine,
  Back,
  Pages,
  Lining,  ///< Insides of the case that lie against the leaves, which hide them, unless the book is
           ///< deformed out of all shape.
};

inline constexpr std::size_t kBookPartCount = 5;

/// Highest BookVertex::surfaceId.
inline constexpr int kMaxSurfaceId = 18;

/// One vertex, laid out as the vertex shader reads it.
struct BookVertex {
  Eigen::Vector3f
      position;  ///< In the unit cube: spine to fore edge, foot to head, back to front cover.
  /// Outward, as a covector of the cube: the cofactors of the map to the world make the world's
  /// normal of it. Of unit length.
  Eigen::Vector3f normal;
  Eigen::Vector2f texture;  ///< Texture coordinates, v upward.
  float skyVisibility = 1;  ///< Share of the surroundings that lights this place. [0 to 1]
  float surfaceId = 0;      ///< Number of the side that this is a point of, 1 to kMaxSurfaceId.
};

/// A row of squares of a part's roundings, rims or hinges: seldom wider than a pixel, while light
/// changes much from one to the next.
struct BookStrip {
  BookPart part = BookPart::Front;
  float length = 0;                ///< In heights of the book, up to 1.
  bool flat = true;                ///< Its normals are the same on both sides.
  std::vector<BookVertex> middle;  ///< From end to end.
  /// Both sides at the squares' ends, likewise; (sides[0][0], sides[0][1], sides[1][0]) turns as
  /// the triangles do.
  std::array<std::vector<Eigen::Vector3f>, 2> sides;
};

/// Triangles, grouped by part.
struct BookMesh {
  std::vector<BookVertex> vertices;
  std::array<std::vector<std::uint32_t>, kBookPartCount>
      triangles;  ///< Vertex indices, three a triangle, by BookPart.
  std::vector<BookStrip> strips;
  /// Of each of those triangles the index of its strip, or kNoStrip.
  std::array<std::vector<std::uint8_t>, kBookPartCount> stripOf;
};

inline constexpr std::uint8_t kNoStrip = 255;

/// Of the trilinear map that takes the unit cube's corners to others.
Eigen::Matrix<double, 8, 1> sharesOfCorners(const Eigen::Vector3f& place);

/// A hardback with a rounded spine, hinges, and boards with rounded edges that overlap a page block
/// with a hollow fore edge. Sides are grids, so that one whose corners leave their plane is still
/// textured without a crease.
BookMesh makeBookMesh();

}  // namespace rotatebook::render
