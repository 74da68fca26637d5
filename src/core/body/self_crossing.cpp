#include "body/self_crossing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <span>
#include <vector>

namespace rotatebook::body {
namespace {

using Eigen::Vector3d;
using Triangle = std::array<std::uint32_t, 3>;

/// The most pairs of boxes that are visited, for each triangle; measured 8 of a ball, 6 of boxes.
constexpr std::size_t kMaxPairs = 60;

/// A box along the axes.
struct Bounds {
  Vector3d low, high;

  void add(const Bounds& other) {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }
  bool meets(const Bounds& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};

/// A node of the tree of boxes: a leaf's triangles, or two children that follow one another.
struct Node {
  Bounds bounds;
  std::uint32_t begin = 0, end = 0;  // of the order of triangles
  std::uint32_t child = 0;           // the first of two; 0 for a leaf
};

/// A tree of boxes around a mesh's triangles.
class BoxTree {
 public:
  explicit BoxTree(const TriangleMesh& mesh) : order_(mesh.triangles.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    for (const Triangle& triangle : mesh.triangles) boxes_.push_back(boxOf(mesh, triangle));
    nodes_.push_back({boundsOf(0, boxes_.size()), 0, static_cast<std::uint32_t>(boxes_.size())});
    for (std::size_t i = 0; i < nodes_.size(); ++i) divide(i);
  }

  /// Calls `visit` with pairs of triangles whose boxes meet, until it returns true, or until there
  /// were kMaxPairs of boxes for each triangle.
  template <typename Visit>
  void visitPairs(const Visit& visit) const {
    std::vector<std::array<std::uint32_t, 2>> pairs{{0, 0}};
    for (std::size_t left = kMaxPairs * order_.size(); left > 0 && !pairs.empty(); --left) {
      const auto [a, b] = pairs.back();
      pairs.pop_back();
      const Node &one = nodes_[a], &other = nodes_[b];
      if (a != b && !one.bounds.meets(other.bounds)) continue;
      if (one.child == 0 && other.child == 0) {
        if (visitLeaves(one, other, visit)) return;
      } else if (a == b) {
        for (const std::uint32_t i : {0U, 1U}) pairs.push_back({one.child + i, one.child + i});
        pairs.push_back({one.child, one.child + 1});
      } else if (other.child == 0 ||
                 (one.child != 0 && one.end - one.begin > other.end - other.begin)) {
        for (const std::uint32_t i : {0U, 1U}) pairs.push_back({one.child + i, b});
      } else {
        for (const std::uint32_t i : {0U, 1U}) pairs.push_back({a, other.child + i});
      }
    }
  }

 private:
  static Bounds boxOf(const TriangleMesh& mesh, const Triangle& triangle) {
    const Vector3d &a = mesh.points[triangle[0]], &b = mesh.points[triangle[1]];
    const Vector3d& c = mesh.points[triangle[2]];
    return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
  }

  Bounds boundsOf(std::size_t begin, std::size_t end) const {
    Bounds bounds = boxes_[order_[begin]];
    for (std::size_t i = begin; i < end; ++i) bounds.add(boxes_[order_[i]]);
    return bounds;
  }

  /// Divides a node's triangles by the middles of their boxes, along its longest side.
  void divide(std::size_t index) {
    constexpr std::uint32_t kLeaf = 4;
    const Node node = nodes_[index];
    if (node.end - node.begin <= kLeaf) return;
    int axis = 0;
    (node.bounds.high - node.bounds.low).maxCoeff(&axis);
    const auto key = [&](std::uint32_t i) {
      return std::pair(boxes_[i].low[axis] + boxes_[i].high[axis], i);
    };
    const std::uint32_t middle = node.begin + (node.end - node.begin) / 2;
    std::nth_element(order_.begin() + node.begin, order_.begin() + middle,
                     order_.begin() + node.end,
                     [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    nodes_[index].child = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({boundsOf(node.begin, middle), node.begin, middle});
    nodes_.push_back({boundsOf(middle, node.end), middle, node.end});
  }

  template <typename Visit>
  bool visitLeaves(const Node& one, const Node& other, const Visit& visit) const {
    for (std::uint32_t i = one.begin; i < one.end; ++i) {
      for (std::uint32_t k = &one == &other ? i + 1 : other.begin; k < other.end; ++k) {
        if (boxes_[order_[i]].meets(boxes_[order_[k]]) && visit(order_[i], order_[k])) return true;
      }
    }
    return false;
  }

  std::vector<Bounds> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

/// Returns on which side of the plane through a, b and c the point d is: 1, -1, or 0 if that isn't
/// sure, by the bound of Shewchuk 1997.
int sideOf(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
  constexpr double kBound = 8e-16;  // (7 + 56 u) u, of rounding errors of u = 2^-53
  const Vector3d p = a - d, q = b - d, r = c - d;
  const double x = q.y() * r.z() - q.z() * r.y(), y = q.z() * r.x() - q.x() * r.z(),
               z = q.x() * r.y() - q.y() * r.x();
  const double determinant = p.x() * x + p.y() * y + p.z() * z;
  const double largest = std::fabs(p.x()) * (std::fabs(q.y() * r.z()) + std::fabs(q.z() * r.y())) +
                         std::fabs(p.y()) * (std::fabs(q.z() * r.x()) + std::fabs(q.x() * r.z())) +
                         std::fabs(p.z()) * (std::fabs(q.x() * r.y()) + std::fabs(q.y() * r.x()));
  const double error = kBound * largest;
  return determinant > error ? 1 : determinant < -error ? -1 : 0;
}

/// The search for crossings of pairs of triangles.
class Crossings {
 public:
  explicit Crossings(const TriangleMesh& mesh) : mesh_(mesh) {}

  bool cross(std::uint32_t one, std::uint32_t other) {
    return anyPasses(one, other) || anyPasses(other, one);
  }

 private:
  /// Returns whether an edge of `one` that has no point of `other` passes through it.
  bool anyPasses(std::uint32_t one, std::uint32_t other) {
    const Triangle &edges = mesh_.triangles[one], &face = mesh_.triangles[other];
    // Points of both are in the face's plane
    std::array<int, 3> sides{};
    for (std::size_t i = 0; i < 3; ++i) {
      if (std::ranges::find(face, edges[i]) != face.end()) continue;
      sides[i] = sideOf(at(face[0]), at(face[1]), at(face[2]), at(edges[i]));
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t k = (i + 1) % 3;
      if (sides[i] * sides[k] >= 0) continue;
      const bool isUp = edges[i] < edges[k];
      if (passes(edges[isUp ? i : k], edges[isUp ? k : i], other, sides[isUp ? i : k])) return true;
    }
    return false;
  }

  /// Returns whether the edge, which goes through the face's plane, goes through the face; `side`
  /// is that of its first point.
  bool passes(std::uint32_t from, std::uint32_t to, std::uint32_t face, int side) {
    const Triangle& triangle = mesh_.triangles[face];
    int sum = 0, zeros = 0;
    std::size_t on = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const int turn = sideOf(at(from), at(to), at(triangle[i]), at(triangle[(i + 1) % 3]));
      sum += turn;
      if (turn != 0) continue;
      ++zeros;
      on = i;
    }
    if (zeros == 0) return sum == 3 || sum == -3;
    if (zeros > 1 || (sum != 2 && sum != -2)) return false;
    return passesAtEdge({from, to, triangle[on], triangle[(on + 1) % 3]}, face, side);
  }

  /// An edge that meets an edge of the face passes through the surface if it passes the other
  /// face there in the same direction: else it touches.
  bool passesAtEdge(std::array<std::uint32_t, 4> edges, std::uint32_t face, int direction) {
    if (edges[2] > edges[3]) std::swap(edges[2], edges[3]);
    const auto [found, isNew] = met_.try_emplace(edges, Met{face, direction});
    return !isNew && found->second.face != face && found->second.direction == direction;
  }

  struct Met {
    std::uint32_t face;
    int direction;
  };

  const Vector3d& at(std::uint32_t point) const { return mesh_.points[point]; }

  const TriangleMesh& mesh_;
  std::map<std::array<std::uint32_t, 4>, Met> met_;
};

}  // namespace

std::optional<std::array<std::size_t, 2>> findSelfCrossing(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return std::nullopt;
  std::optional<std::array<std::size_t, 2>> found;
  Crossings crossings(mesh);
  BoxTree(mesh).visitPairs([&](std::uint32_t a, std::uint32_t b) {
    if (crossings.cross(a, b)) found = {std::min(a, b), std::max(a, b)};
    return found.has_value();
  });
  return found;
}

}  // namespace rotatebook::body
