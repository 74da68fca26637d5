#include "geometry/sky_visibility.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "base/elementary.h"
#include "geometry/depth_map.h"

namespace rotatebook::geometry {
namespace {

using Eigen::Vector3d;
using Triangle = std::array<std::uint32_t, 3>;

constexpr int kDirections = 64;
// Longer edges are halved, and shorter ones aren't. [radii of the body]
constexpr double kCoarse = 1, kFine = 0.12;
constexpr float kUneven = 0.08F;               // Deviation from linear at which edges are halved.
constexpr float kHidden = 0.15F;               // At most: within the body, or as deep in a corner.
constexpr std::size_t kMostVertices = 60'000;  // Beyond, meshes aren't refined.
constexpr int kRounds = 6;                     // Of halving.

/// Returns direction `i`, evenly spread over the sphere (a spherical Fibonacci lattice).
Vector3d directionOf(int i) {
  constexpr double kGoldenAngle = 2.39996322972865332;
  const double z = 1 - (2 * i + 1.0) / kDirections, across = std::sqrt(1 - z * z);
  const CosineSine turn = cosineSine({kGoldenAngle * i, 0});
  return {across * turn.cosine, across * turn.sine, z};
}

/// A body from all around.
class Surroundings {
 public:
  Surroundings(const Vector3d& size, const Mesh& mesh) : size_(size) {
    Vector3d low = Vector3d::Constant(std::numeric_limits<double>::max()), high = -low;
    for (const MeshVertex& vertex : mesh.vertices) {
      const Vector3d point = vertex.position.cast<double>().cwiseProduct(size);
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
    middle_ = (low + high) / 2;
    radius_ = (high - low).norm() / 2;
    for (int i = 0; i < kDirections; ++i) maps_.push_back(mapOf(directionOf(i), mesh));
  }

  /// Returns a vertex's place. [radii of the body]
  Vector3d pointOf(const MeshVertex& vertex) const {
    return (vertex.position.cast<double>().cwiseProduct(size_) - middle_) / radius_;
  }

  Vector3d normalOf(const MeshVertex& vertex) const {
    return vertex.normal.cast<double>().cwiseQuotient(size_).normalized();
  }

  /// Returns false if the body is so thin at a vertex that the maps' pixels don't show its shadow.
  bool isThick(const MeshVertex& vertex) const {
    return seenFrom(vertex, -2 * DepthMap::kOffset * normalOf(vertex)) <= kHidden;
  }

  /// Returns the share of its surroundings that is seen beside a vertex. [radii of the body]
  float seenFrom(const MeshVertex& vertex, const Vector3d& beside) const {
    const Vector3d normal = normalOf(vertex), point = pointOf(vertex) + beside;
    double seen = 0, all = 0;
    for (const DepthMap& map : maps_) {
      const double cosine = normal.dot(map.direction());
      if (!(cosine > 0)) continue;
      all += cosine;
      seen += cosine * map.seenShare(map.placeOf(point));
    }
    return static_cast<float>(seen / all);
  }

  /// Returns the vertex in the middle between two, as it is seen beside it.
  MeshVertex between(const MeshVertex& a, const MeshVertex& b, const Vector3d& beside) const {
    const Vector3d normal = (normalOf(a) + normalOf(b)).cwiseProduct(size_).normalized();
    MeshVertex middle{(a.position + b.position) / 2, normal.cast<float>(),
                      (a.texCoord + b.texCoord) / 2, 1, a.surfaceId};
    middle.skyVisibility = seenFrom(middle, beside);
    return middle;
  }

 private:
  DepthMap mapOf(const Vector3d& direction, const Mesh& mesh) const {
    DepthMap map(direction);
    std::vector<Vector3d> places;
    for (const MeshVertex& vertex : mesh.vertices) places.push_back(map.placeOf(pointOf(vertex)));
    for (const MeshPart& part : mesh.parts) {
      for (std::size_t i = 0; i < part.triangles.size(); i += 3) {
        const std::uint32_t* corners = &part.triangles[i];
        map.draw(places[corners[0]], places[corners[1]], places[corners[2]]);
      }
    }
    return map;
  }

  Vector3d size_, middle_;
  double radius_ = 0;
  std::vector<DepthMap> maps_;
};

/// Finds what a mesh's vertices see, and halves its edges where that varies along them.
class Refiner {
 public:
  Refiner(const Surroundings& surroundings, std::vector<std::uint32_t> places, Mesh& mesh)
      : surroundings_(surroundings), mesh_(mesh), places_(std::move(places)) {
    for (const std::uint32_t place : places_) placeCount_ = std::max(placeCount_, place + 1);
    // In a corner the shadow of none of its sides is doubtful away from all of them
    std::vector<Vector3d> away(placeCount_, Vector3d::Zero());
    for (std::size_t i = 0; i < places_.size(); ++i)
      away[places_[i]] += DepthMap::kOffset * surroundings.normalOf(mesh.vertices[i]);
    for (std::size_t i = 0; i < places_.size(); ++i) {
      lifts_.push_back(away[places_[i]]);
      mesh.vertices[i].skyVisibility = surroundings.seenFrom(mesh.vertices[i], lifts_.back());
    }
  }

  /// Halves edges once; returns false if there is none to halve.
  bool refine() {
    halved_.clear();
    for (const MeshPart& part : mesh_.parts) {
      for (std::size_t i = 0; i < part.triangles.size(); ++i) {
        const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
        look(part.triangles[i], part.triangles[next]);
      }
    }
    if (halved_.empty()) return false;
    middles_.clear();
    for (MeshPart& part : mesh_.parts) split(part);
    return true;
  }

 private:
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  static Edge edgeOf(std::uint32_t a, std::uint32_t b) { return std::minmax(a, b); }

  Vector3d liftBetween(const Edge& edge) const {
    return (lifts_[edge.first] + lifts_[edge.second]) / 2;
  }

  /// Notes an edge between two vertices if it is to be halved, for all sides that meet in it.
  void look(std::uint32_t from, std::uint32_t to) {
    const Edge places = edgeOf(places_[from], places_[to]), edge = edgeOf(from, to);
    const MeshVertex &a = mesh_.vertices[edge.first], &b = mesh_.vertices[edge.second];
    const double length = (surroundings_.pointOf(a) - surroundings_.pointOf(b)).norm();
    if (length < kFine || halved_.contains(places) || smooth_.contains(edge)) return;
    const MeshVertex middle = surroundings_.between(a, b, liftBetween(edge));
    const float apart = std::abs(middle.skyVisibility - (a.skyVisibility + b.skyVisibility) / 2);
    if ((length > kCoarse || apart > kUneven) && surroundings_.isThick(middle))
      halved_[places] = placeCount_++;
    else
      smooth_[edge] = 0;
  }

  /// Returns the vertex in the middle of an edge that is halved.
  std::uint32_t middleOf(std::uint32_t from, std::uint32_t to) {
    const auto [low, high] = edgeOf(from, to);
    const auto next = static_cast<std::uint32_t>(mesh_.vertices.size());
    const auto [found, isNew] = middles_.try_emplace({low, high}, next);
    if (isNew) {
      places_.push_back(halved_[edgeOf(places_[from], places_[to])]);
      lifts_.push_back(liftBetween({low, high}));
      mesh_.vertices.push_back(
          surroundings_.between(mesh_.vertices[low], mesh_.vertices[high], lifts_.back()));
    }
    return found->second;
  }

  void split(MeshPart& part) {
    std::vector<std::uint32_t> whole;
    whole.swap(part.triangles);
    for (std::size_t i = 0; i < whole.size(); i += 3)
      splitTriangle({whole[i], whole[i + 1], whole[i + 2]}, part);
    part.stripOf.assign(part.triangles.size() / 3, kNoStrip);
  }

  /// Adds what the halves of its edges make of a triangle. Its surface is that of its last corner.
  void splitTriangle(const Triangle& whole, MeshPart& part) {
    std::vector<std::uint32_t> outline;  // From a corner to which a halved edge leads.
    const auto isHalved = [&](std::size_t i) {
      return halved_.contains(edgeOf(places_[whole[i]], places_[whole[(i + 1) % 3]]));
    };
    std::size_t first = 0;
    for (std::size_t i = 0; i < 3; ++i)
      if (!isHalved(i) && isHalved((i + 2) % 3)) first = i;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (first + k) % 3;
      outline.push_back(whole[i]);
      if (isHalved(i)) outline.push_back(middleOf(whole[i], whole[(i + 1) % 3]));
    }
    addOutline(outline, part);
  }

  /// Adds the triangles of an outline of 3 to 6 corners.
  void addOutline(const std::vector<std::uint32_t>& outline, MeshPart& part) {
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      part.triangles.insert(part.triangles.end(), {outline[a], outline[b], outline[c]});
    };
    if (outline.size() == 6) {
      for (const std::size_t i : {1, 3, 5}) add(i, (i + 1) % 6, (i + 2) % 6);
      return add(1, 3, 5);
    }
    // Of 5, the corner between both halved edges is cut off: the third; of 4, one is halved
    if (outline.size() == 5) {
      add(2, 3, 4);
      add(0, 1, 2);
      return add(0, 2, 4);
    }
    const std::size_t last = outline.size() - 1;
    if (last == 3) add(1, 2, 3);
    add(0, 1, last);
  }

  const Surroundings& surroundings_;
  Mesh& mesh_;
  std::vector<std::uint32_t> places_;  // By vertex.
  std::uint32_t placeCount_ = 0;
  std::vector<Vector3d> lifts_;  // By vertex: to where it is seen from. [radii of the body]
  // Of edges between places that of their middle; edges between vertices that stay; of those that
  // don't, the vertex in the middle.
  std::map<Edge, std::uint32_t> halved_, smooth_, middles_;
};

/// Gives vertices within the body, which see nothing, the mean of what their neighbours see, so
/// that they darken nothing outside it.
void lightHidden(Mesh& mesh) {
  std::vector<float> sums(mesh.vertices.size(), 0), counts(sums);
  for (const MeshPart& part : mesh.parts) {
    for (std::size_t i = 0; i < part.triangles.size(); ++i) {
      const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
      const std::uint32_t a = part.triangles[i], b = part.triangles[next];
      for (const auto& [to, from] : {std::pair(a, b), std::pair(b, a)}) {
        if (mesh.vertices[from].skyVisibility <= kHidden) continue;
        sums[to] += mesh.vertices[from].skyVisibility;
        counts[to] += 1;
      }
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    float& visibility = mesh.vertices[i].skyVisibility;
    if (visibility <= kHidden) visibility = counts[i] > 0 ? sums[i] / counts[i] : 1;
  }
}

}  // namespace

void addSkyVisibility(const Vector3d& size, std::vector<std::uint32_t> places, Mesh& mesh) {
  const Surroundings surroundings(size, mesh);
  Refiner refiner(surroundings, std::move(places), mesh);
  for (int i = 0; i < kRounds && mesh.vertices.size() < kMostVertices; ++i) {
    if (!refiner.refine()) break;
  }
  lightHidden(mesh);
}

}  // namespace rotatebook::geometry
