// The book's surface as a mesh.
#pragma once

#include <cstddef>

#include "geometry/mesh.h"

namespace rotatebook::geometry {

/// The parts of the book's mesh, by index.
enum class BookPart {
  Front,
  Spine,
  Back,
  Pages,
  Lining,  ///< The case's inner sides that the leaves hide.
};

inline constexpr std::size_t kBookPartCount = 5;

/// Fineness of the mesh.
enum class MeshDetail {
  Full,   ///< For pictures of every size.
  Small,  ///< A fifth of the triangles, for a book of up to some hundred pixels among many.
};

/// Makes a hardback with a rounded spine, hinges, and boards with rounded edges that overlap a page
/// block with a hollow fore edge. Sides are grids, so that one whose corners leave their plane is
/// still textured without a crease. In the unit cube: spine to fore edge, foot to head, back to
/// front cover.
Mesh makeBookMesh(MeshDetail detail = MeshDetail::Full);

}  // namespace rotatebook::geometry
