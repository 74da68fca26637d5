#include "body/mesh_edges.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace rotatebook::body {
namespace {

template <typename Visit>
void visitSides(const TriangleMesh& mesh, const Visit& visit) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t a = mesh.triangles[i][corner], b = mesh.triangles[i][(corner + 1) % 3];
      visit(std::min(a, b),
            Side{std::max(a, b), static_cast<std::uint32_t>(3 * i + corner), a < b});
    }
  }
}

}  // namespace

MeshEdges::MeshEdges(const TriangleMesh& mesh)
    : begins_(mesh.points.size() + 1), sides_(3 * mesh.triangles.size()) {
  visitSides(mesh, [this](std::uint32_t begin, const Side&) { ++begins_[begin + 1]; });
  std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
  std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
  visitSides(mesh, [&](std::uint32_t begin, const Side& side) { sides_[next[begin]++] = side; });
  const auto key = [](const Side& side) { return std::pair(side.end, side.number); };
  for (std::size_t point = 0; point < mesh.points.size(); ++point) {
    const auto at = [&](std::size_t i) { return sides_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::sort(at(begins_[point]), at(begins_[point + 1]),
              [&](const Side& a, const Side& b) { return key(a) < key(b); });
  }
}

}  // namespace rotatebook::body
