#include "body/voids.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "base/disjoint_sets.h"
#include "base/error.h"

namespace rotatebook::body {
namespace {

using Eigen::Vector3d;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// A surface that shares no point with others.
struct Surround {
  std::size_t triangle = 0;  // one of its
  double volume = 0;         // six times, below 0 if it faces inward
  Vector3d low = Vector3d::Constant(kInfinite), high = -low;

  bool holds(const Surround& other, double room) const {
    return (other.low.array() >= low.array() - room).all() &&
           (other.high.array() <= high.array() + room).all();
  }
};

std::vector<Surround> surfacesOf(const TriangleMesh& mesh) {
  DisjointSets sets(mesh.points.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    sets.join(a, b);
    sets.join(b, c);
  }
  constexpr std::size_t kUnassigned = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> places(mesh.points.size(), kUnassigned);
  std::vector<Surround> surfaces;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    std::size_t& place = places[sets.of(mesh.triangles[i][0])];
    if (place == kUnassigned) {
      place = surfaces.size();
      surfaces.push_back({i});
    }
    Surround& surface = surfaces[place];
    // About a point of its own, so that little is lost far off
    const Vector3d& origin = mesh.points[mesh.triangles[surface.triangle][0]];
    const auto corner = [&](std::size_t k) -> const Vector3d& {
      return mesh.points[mesh.triangles[i][k]];
    };
    surface.volume += (corner(0) - origin).dot((corner(1) - origin).cross(corner(2) - origin));
    for (std::size_t k = 0; k < 3; ++k) {
      surface.low = surface.low.cwiseMin(corner(k));
      surface.high = surface.high.cwiseMax(corner(k));
    }
  }
  return surfaces;
}

}  // namespace

void requireVoidsInside(const TriangleMesh& mesh, std::span<const std::uint32_t> numbers) {
  constexpr double kFlat = 1e-9, kRoom = 1e-6;
  constexpr std::size_t kMaxComparisons = 10'000'000;
  std::vector<Surround> outward, inward;
  for (const Surround& one : surfacesOf(mesh)) {
    const double size = (one.high - one.low).maxCoeff();
    const bool isFlat = std::fabs(one.volume) <= kFlat * size * size * size;
    if (!isFlat) (one.volume > 0 ? outward : inward).push_back(one);
  }
  if (outward.empty() || inward.size() > kMaxComparisons / outward.size()) return;
  std::ranges::stable_sort(outward, std::ranges::greater{}, &Surround::volume);
  for (const Surround& one : inward) {
    const double room = kRoom * (one.high - one.low).maxCoeff();
    const auto holds = [&](const Surround& other) { return other.holds(one, room); };
    if (std::ranges::any_of(outward, holds)) continue;
    const std::size_t number = numbers.empty() ? one.triangle : numbers[one.triangle];
    throw InputError("the closed surface of triangle " + std::to_string(number + 1) +
                     " faces inward, and is in no other from which it could take away; turn its "
                     "triangles' corners round");
  }
}

}  // namespace rotatebook::body
