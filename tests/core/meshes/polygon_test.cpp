#include "meshes/polygon.h"

#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"

namespace rotatebook::meshes {
namespace {

using Eigen::Vector3d;

/// Returns the triangles of an outline in the plane z = 0, counter-clockwise.
body::TriangleMesh trianglesOf(const std::vector<Vector3d>& outline) {
  body::TriangleMesh mesh{outline, {}};
  std::vector<std::uint32_t> corners(outline.size());
  std::iota(corners.begin(), corners.end(), 0U);
  addPolygon(corners, mesh);
  return mesh;
}

/// Returns twice a triangle's area, below 0 if it is clockwise.
double areaOf(const body::TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const Vector3d &a = mesh.points[triangle[0]], &b = mesh.points[triangle[1]];
  return (b - a).cross(mesh.points[triangle[2]] - a).z();
}

double totalArea(const body::TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& triangle : mesh.triangles) sum += areaOf(mesh, triangle);
  return sum;
}

TEST(Polygon, IsAFanIfItIsConvex) {
  const body::TriangleMesh mesh = trianglesOf({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  const std::vector<std::array<std::uint32_t, 3>> expected{{0, 1, 2}, {0, 2, 3}};
  EXPECT_EQ(mesh.triangles, expected);
}

// A notch, a comb and an L, from each of their corners on.
TEST(Polygon, HasNoTriangleOutsideIfItIsConcave) {
  const std::vector<std::vector<Vector3d>> outlines{
      {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {2, 1, 0}, {0, 3, 0}},
      {{0, 0, 0},
       {7, 0, 0},
       {7, 3, 0},
       {6, 3, 0},
       {6, 1, 0},
       {4, 1, 0},
       {4, 3, 0},
       {3, 3, 0},
       {3, 1, 0},
       {0, 1, 0}},
      {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}};
  const std::vector<double> areas{2 * 8.0, 2 * 11.0, 2 * 3.0};
  for (std::size_t k = 0; k < outlines.size(); ++k) {
    std::vector<Vector3d> outline = outlines[k];
    for (std::size_t i = 0; i < outline.size(); ++i) {
      std::rotate(outline.begin(), outline.begin() + 1, outline.end());
      const body::TriangleMesh mesh = trianglesOf(outline);
      EXPECT_EQ(mesh.triangles.size(), outline.size() - 2);
      EXPECT_EQ(totalArea(mesh), areas[k]);
      for (const auto& triangle : mesh.triangles) EXPECT_GT(areaOf(mesh, triangle), 0) << k << i;
    }
  }
}

// A square with a hole, to which the outline goes along a bridge, and back.
TEST(Polygon, MayGoToAHoleAndBack) {
  const std::vector<Vector3d> points{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0},
                                     {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}};
  std::vector<std::uint32_t> corners{0, 1, 2, 3, 0, 4, 7, 6, 5, 4};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    body::TriangleMesh mesh{points, {}};
    addPolygon(corners, mesh);
    EXPECT_EQ(mesh.triangles.size(), 8U) << i;
    EXPECT_EQ(totalArea(mesh), 2 * 8.0) << i;
    for (const auto& triangle : mesh.triangles) EXPECT_GT(areaOf(mesh, triangle), 0) << i;
  }
}

TEST(Polygon, IsRefusedIfItIsConcaveAndHasManyCorners) {
  std::vector<Vector3d> saw;
  for (int i = 0; i < 1001; ++i) saw.emplace_back(i, i % 2, 0);
  saw.emplace_back(500, 9, 0);
  EXPECT_THROW(trianglesOf(saw), InputError);
}

}  // namespace
}  // namespace rotatebook::meshes
