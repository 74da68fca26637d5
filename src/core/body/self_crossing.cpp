#include "body/self_crossing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <span>
#include <tuple>
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
  /// were kMaxPairs of boxes for each triangle. Returns whether all were visited.
  template <typename Visit>
  bool visitPairs(const Visit& visit) const {
    std::vector<std::array<std::uint32_t, 2>> pairs{{0, 0}};
    for (std::size_t left = kMaxPairs * order_.size(); left > 0 && !pairs.empty(); --left) {
      const auto [a, b] = pairs.back();
      pairs.pop_back();
      const Node &one = nodes_[a], &other = nodes_[b];
      if (a != b && !one.bounds.meets(other.bounds)) continue;
      if (one.child == 0 && other.child == 0) {
        if (visitLeaves(one, other, visit)) return false;
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
    return pairs.empty();
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

  /// Returns two triangles of which one has an edge that passes through the surface at an edge of
  /// the other, once all pairs were visited: it enters two faces more than it leaves there, or
  /// leaves more; where it is one, it lies in the plane of another. Nothing if there are none.
  std::optional<std::array<std::size_t, 2>> crossingAtEdges() const {
    for (auto first = met_.begin(); first != met_.end();) {
      int sum = 0;
      auto next = first;
      for (; next != met_.end() && next->first.edges == first->first.edges; ++next)
        sum += next->second.direction;
      const std::size_t one = first->second.triangle, other = first->first.face;
      if (sum > 1 || sum < -1) return std::array{std::min(one, other), std::max(one, other)};
      first = next;
    }
    return std::nullopt;
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
      if (passes({edges[isUp ? i : k], edges[isUp ? k : i]}, one, other, sides[isUp ? i : k]))
        return true;
    }
    return false;
  }

  /// Returns whether an edge of `one`, which goes through the face's plane, goes through the face;
  /// `side` is that of its first point.
  bool passes(const std::array<std::uint32_t, 2>& ends, std::uint32_t one, std::uint32_t face,
              int side) {
    const Triangle& triangle = mesh_.triangles[face];
    int sum = 0, zeros = 0;
    std::size_t on = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const int turn = sideOf(at(ends[0]), at(ends[1]), at(triangle[i]), at(triangle[(i + 1) % 3]));
      sum += turn;
      if (turn != 0) continue;
      ++zeros;
      on = i;
    }
    if (zeros == 0) return sum == 3 || sum == -3;
    if (zeros > 1 || (sum != 2 && sum != -2)) return false;
    // It meets an edge of the face: all faces there decide
    const auto [low, high] = std::minmax({triangle[on], triangle[(on + 1) % 3]});
    met_.try_emplace({{ends[0], ends[1], low, high}, face}, Met{one, side});
    return false;
  }

  /// Two edges that meet, each from its smaller point's index, and a face at the second.
  struct Meeting {
    std::array<std::uint32_t, 4> edges;
    std::uint32_t face;
    bool operator<(const Meeting& other) const {
      return std::tie(edges, face) < std::tie(other.edges, other.face);
    }
  };
  /// A triangle that has the first edge, and on which side of the face that begins.
  struct Met {
    std::uint32_t triangle;
    int direction;
  };

  const Vector3d& at(std::uint32_t point) const { return mesh_.points[point]; }

  const TriangleMesh& mesh_;
  std::map<Meeting, Met> met_;
};

}  // namespace

std::optional<std::array<std::size_t, 2>> findSelfCrossing(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return std::nullopt;
  std::optional<std::array<std::size_t, 2>> found;
  Crossings crossings(mesh);
  const bool isWhole = BoxTree(mesh).visitPairs([&](std::uint32_t a, std::uint32_t b) {
    if (crossings.cross(a, b)) found = {std::min(a, b), std::max(a, b)};
    return found.has_value();
  });
  return isWhole ? crossings.crossingAtEdges() : found;
}

}  // namespace rotatebook::body
