// The edges of a mesh, with the triangles at each. Inside the room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "body/triangle_mesh.h"

namespace rotatebook::body {

/// A triangle's side from one of its corners to the next, at the edge from its smaller point's
/// index to `end`, the larger one.
struct Side {
  std::uint32_t end;
  std::uint32_t number;  ///< 3 for each triangle: 3 times the triangle's, and the corner's.
  bool isForward;        ///< The triangle runs from the smaller to the larger index.

  std::uint32_t triangle() const { return number / 3; }
};

/// Returns the corner of a side's triangle that isn't on the edge.
inline std::uint32_t oppositeOf(const TriangleMesh& mesh, const Side& side) {
  return mesh.triangles[side.triangle()][(side.number + 2) % 3];
}

/// The sides of a mesh, those of each edge together, by their numbers. No triangle has a corner
/// twice. Takes time in proportion to the triangles.
class MeshEdges {
 public:
  explicit MeshEdges(const TriangleMesh& mesh);

  /// Calls visit(point, sides) for each edge, `point` being that with the smaller index.
  template <typename Visit>
  void forEach(const Visit& visit) const {
    for (std::size_t point = 0; point + 1 < begins_.size(); ++point) {
      for (std::size_t i = begins_[point]; i < begins_[point + 1];) {
        std::size_t end = i + 1;
        while (end < begins_[point + 1] && sides_[end].end == sides_[i].end) ++end;
        visit(static_cast<std::uint32_t>(point), std::span<const Side>(sides_).subspan(i, end - i));
        i = end;
      }
    }
  }

 private:
  std::vector<std::size_t> begins_;  // By point, and the end.
  std::vector<Side> sides_;
};

}  // namespace rotatebook::body
