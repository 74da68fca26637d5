#include "meshes/polygon.h"

#include <array>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "base/error.h"

namespace rotatebook::meshes {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kMaxConcave = 1000;  // corners, whose triangles take time with their square

[[noreturn]] void failAsTooLarge(const char* what) {
  throw InputError("there are more than " + std::to_string(body::kMaxTriangles) + " " + what +
                   "; export a coarser mesh");
}

/// A polygon that is cut into triangles.
class Polygon {
 public:
  Polygon(std::span<const std::uint32_t> corners, body::TriangleMesh& mesh)
      : corners_(corners.begin(), corners.end()), mesh_(mesh) {
    for (std::size_t i = 0; i < corners_.size(); ++i)
      normal_ += (at(i) - at(0)).cross(at(i + 1) - at(0));
  }

  bool isConvex() const {
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (turn(at(i), at(i + 1), at(i + 2)) < 0) return false;
    }
    return true;
  }

  /// Adds all as triangles around the first corner.
  void addFan() {
    for (std::size_t i = 2; i < corners_.size(); ++i)
      mesh_.triangles.push_back({corners_[0], corners_[i - 1], corners_[i]});
  }

  /// Adds ears, corners whose triangle lies inside and has no other corner in it, until none is
  /// left.
  void cutEars() {
    for (std::size_t i = 0; i < corners_.size() && corners_.size() > 3;) {
      if (!isEar(i)) {
        ++i;
        continue;
      }
      const std::size_t ear = (i + 1) % corners_.size();
      mesh_.triangles.push_back({number(i), number(i + 1), number(i + 2)});
      corners_.erase(corners_.begin() + static_cast<std::ptrdiff_t>(ear));
      i = 0;
    }
  }

 private:
  std::uint32_t number(std::size_t i) const { return corners_[i % corners_.size()]; }
  const Vector3d& at(std::size_t i) const { return mesh_.points[number(i)]; }

  /// Returns a number above 0 if the outline turns left at `b`, as seen from outside.
  double turn(const Vector3d& a, const Vector3d& b, const Vector3d& c) const {
    return normal_.dot((b - a).cross(c - b));
  }

  /// Returns whether corner i + 1 is an ear.
  bool isEar(std::size_t i) const {
    const Vector3d &a = at(i), &b = at(i + 1), &c = at(i + 2);
    if (!(turn(a, b, c) > 0)) return false;
    for (std::size_t k = i + 3; k < i + corners_.size(); ++k) {
      const Vector3d& other = at(k);
      // An outline that goes to a hole and back meets its own corners.
      if (other == a || other == b || other == c) continue;
      if (turn(a, b, other) >= 0 && turn(b, c, other) >= 0 && turn(c, a, other) >= 0) return false;
    }
    return true;
  }

  std::vector<std::uint32_t> corners_;
  body::TriangleMesh& mesh_;
  Vector3d normal_{0, 0, 0};
};

}  // namespace

void addPolygon(std::span<const std::uint32_t> corners, body::TriangleMesh& mesh) {
  requireFewTriangles(mesh.triangles.size() + corners.size());
  Polygon polygon(corners, mesh);
  if (!polygon.isConvex()) {
    if (corners.size() > kMaxConcave) {
      throw InputError("a face of " + std::to_string(corners.size()) +
                       " corners isn't convex; export triangles");
    }
    polygon.cutEars();
  }
  polygon.addFan();
}

void requireFewTriangles(std::size_t count) {
  if (count > body::kMaxTriangles) failAsTooLarge("triangles");
}

void requireFewPoints(std::size_t count) {
  if (count > body::kMaxTriangles) failAsTooLarge("points");
}

}  // namespace rotatebook::meshes
