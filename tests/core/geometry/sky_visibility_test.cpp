// Shadows that bodies cast on themselves.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "body/shape.h"
#include "geometry/body_mesh.h"

namespace rotatebook::geometry {
namespace {

using Eigen::Vector3d;

body::Surface lookOf(const char* name) {
  const body::Shape& shape = *body::findShape(name);
  std::vector<double> lengths;
  for (const body::ShapeLength& length : shape.lengths) lengths.push_back(length.byDefault);
  if (shape.look != nullptr) return shape.look(lengths);
  return {.mesh = shape.solid(lengths).surface};
}

/// Returns the size of a box around the origin.
Vector3d sizeOf(const body::Surface& surface) {
  const body::Box box = body::boxAround(surface.mesh.points);
  return 2 * box.high.cwiseMax(-box.low);
}

Vector3d placeOf(const MeshVertex& vertex, const Vector3d& size) {
  return (vertex.position.cast<double>() - Vector3d::Constant(0.5)).cwiseProduct(size);
}

/// Returns a box from `low` to `high`.
body::TriangleMesh boxFrom(const Vector3d& low, const Vector3d& high) {
  const Vector3d size = high - low;
  body::TriangleMesh mesh =
      body::findShape("box")->solid(std::array{size.x(), size.y(), size.z()}).surface;
  for (Vector3d& point : mesh.points) point += (low + high) / 2;
  return mesh;
}

TEST(SkyVisibility, OfConvexBodiesIsWhole) {
  for (const char* name : {"box", "ellipsoid", "cylinder"}) {
    const body::Surface surface = lookOf(name);
    const Mesh mesh = makeShadowedBodyMesh(surface, sizeOf(surface));
    EXPECT_EQ(mesh.vertices.size(), makeBodyMesh(surface, sizeOf(surface)).vertices.size()) << name;
    for (const MeshVertex& vertex : mesh.vertices) ASSERT_EQ(vertex.skyVisibility, 1) << name;
  }
}

/// Returns a floor at z = 0, from x = 0, in squares.
body::TriangleMesh floorOf(std::uint32_t across, std::uint32_t along, double square) {
  body::TriangleMesh mesh;
  for (std::uint32_t i = 0; i <= across; ++i) {
    for (std::uint32_t j = 0; j <= along; ++j) {
      mesh.points.emplace_back(square * i, square * (j - along / 2.0), 0);
      if (i == across || j == along) continue;
      const std::uint32_t a = i * (along + 1) + j, b = a + along + 1;
      mesh.triangles.push_back({a, b, a + 1});
      mesh.triangles.push_back({b, b + 1, a + 1});
    }
  }
  return mesh;
}

// A wall of height 1 across a floor: a point at the distance x loses (1 - x / sqrt(x^2 + 1)) / 2,
// if the wall is long.
TEST(SkyVisibility, BesideAWallIsTheExactShare) {
  body::Surface surface{.mesh = floorOf(10, 60, 0.2)};
  body::append(boxFrom({-0.3, -6, -0.3}, {0, 6, 1}), surface.mesh);
  const Vector3d size = sizeOf(surface);
  int seen = 0;
  double worst = 0;
  for (const MeshVertex& vertex : makeShadowedBodyMesh(surface, size).vertices) {
    const Vector3d place = placeOf(vertex, size);
    if (std::abs(place.z()) > 1e-6 || place.x() < 0.1 || std::abs(place.y()) > 2.1) continue;
    ++seen;
    const double exact = (1 + place.x() / std::hypot(place.x(), 1)) / 2;
    worst = std::max(worst, std::abs(vertex.skyVisibility - exact));
  }
  EXPECT_EQ(seen, 10 * 21);
  EXPECT_LT(worst, 0.05);  // measured 0.048
}

// Half of the surroundings where floor and wall meet, from either.
TEST(SkyVisibility, InACornerIsAHalf) {
  const std::array<Eigen::Vector2d, 6> outline{{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}};
  body::Surface surface;
  for (const double z : {-4.0, 4.0})
    for (const Eigen::Vector2d& point : outline)
      surface.mesh.points.emplace_back(point.x() - 2, point.y() - 2, z);
  for (std::uint32_t i = 0; i < 6; ++i) {
    surface.mesh.triangles.push_back({i, (i + 1) % 6, i + 6});
    surface.mesh.triangles.push_back({(i + 1) % 6, (i + 1) % 6 + 6, i + 6});
  }
  // Both ends, fans from the corner, from which all is seen
  for (const std::uint32_t i : {4U, 5U, 0U, 1U}) {
    surface.mesh.triangles.push_back({3, (i + 1) % 6, i});
    surface.mesh.triangles.push_back({9, i + 6, (i + 1) % 6 + 6});
  }
  int seen = 0;
  double worst = 0;
  for (const MeshVertex& vertex : makeShadowedBodyMesh(surface, {4, 4, 8}).vertices) {
    const Vector3d place = placeOf(vertex, {4, 4, 8});
    if (place.head<2>() != Eigen::Vector2d(-1, -1) || std::abs(place.z()) > 2) continue;
    ++seen;
    worst = std::max(worst, std::abs(vertex.skyVisibility - 0.5));
  }
  EXPECT_GE(seen, 6);      // measured 6
  EXPECT_LT(worst, 0.03);  // measured 0.013
}

// A pillar's foot, within the floor, sees nothing; it doesn't darken the pillar.
TEST(SkyVisibility, OfWhatIsHiddenDarkensNothing) {
  body::Surface surface{.mesh = boxFrom({-2, -2, -1}, {2, 2, 0})};
  body::append(boxFrom({-0.45, -0.4, -0.9}, {0.45, 0.4, 3}), surface.mesh);
  double least = 1;
  for (const MeshVertex& vertex : makeShadowedBodyMesh(surface, {4, 4, 6}).vertices) {
    const Vector3d place = placeOf(vertex, {4, 4, 6});
    const bool isOfPillar = std::abs(place.x()) < 0.46 && std::abs(place.y()) < 0.41;
    if (isOfPillar && place.z() > 0.1) least = std::min(least, double{vertex.skyVisibility});
  }
  EXPECT_GT(least, 0.45);  // measured 0.54
}

using Place = std::tuple<float, float, float>;

/// Returns how often each edge is run along from its first place to its second, less the reverse.
std::map<std::pair<Place, Place>, int> runsOf(const Mesh& mesh) {
  std::map<std::pair<Place, Place>, int> runs;
  const auto place = [&](std::uint32_t i) {
    const Eigen::Vector3f& at = mesh.vertices[i].position;
    return Place(at.x(), at.y(), at.z());
  };
  for (const MeshPart& part : mesh.parts) {
    for (std::size_t i = 0; i < part.triangles.size(); ++i) {
      const Place a = place(part.triangles[i]);
      const Place b = place(part.triangles[i % 3 == 2 ? i - 2 : i + 1]);
      runs[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  return runs;
}

double areaOf(const Mesh& mesh, const Vector3d& size) {
  double area = 0;
  for (const MeshPart& part : mesh.parts) {
    for (std::size_t i = 0; i < part.triangles.size(); i += 3) {
      std::array<Vector3d, 3> places;
      for (std::size_t k = 0; k < 3; ++k)
        places[k] = placeOf(mesh.vertices[part.triangles[i + k]], size);
      area += (places[1] - places[0]).cross(places[2] - places[0]).norm() / 2;
    }
  }
  return area;
}

TEST(SkyVisibility, LeavesSurfacesClosedAndTheSame) {
  for (const char* name : {"t-handle", "wing-nut", "cards", "phone"}) {
    const body::Surface surface = lookOf(name);
    const Vector3d size = sizeOf(surface);
    const Mesh plain = makeBodyMesh(surface, size), mesh = makeShadowedBodyMesh(surface, size);
    EXPECT_GT(mesh.vertices.size(), plain.vertices.size()) << name;
    EXPECT_LT(mesh.vertices.size(), 3 * plain.vertices.size()) << name;  // measured 1.95, t-handle
    EXPECT_NEAR(areaOf(mesh, size) / areaOf(plain, size), 1, 1e-5) << name;  // measured 2e-10
    for (const MeshPart& part : mesh.parts)
      EXPECT_EQ(part.stripOf.size(), part.triangles.size() / 3) << name;
    for (const auto& [edge, runs] : runsOf(mesh)) ASSERT_EQ(runs, 0) << name;
  }
}

// What is too thin for the maps, as a racket's strings, isn't refined.
TEST(SkyVisibility, RefinesNoStrings) {
  const body::Surface racket = lookOf("racket");
  const Vector3d size = sizeOf(racket);
  EXPECT_LT(makeShadowedBodyMesh(racket, size).vertices.size(),
            makeBodyMesh(racket, size).vertices.size() * 12 / 10);  // measured 1.03
}

TEST(SkyVisibility, HasTheSameBitsEverywhere) {
  const body::Surface surface = lookOf("t-handle");
  std::uint64_t sum = 0;
  for (const MeshVertex& vertex : makeShadowedBodyMesh(surface, sizeOf(surface)).vertices) {
    sum = 31 * sum + static_cast<std::uint64_t>(std::ldexp(vertex.skyVisibility, 24));
  }
  EXPECT_EQ(sum, 15244173159348014938U);
}

}  // namespace
}  // namespace rotatebook::geometry
