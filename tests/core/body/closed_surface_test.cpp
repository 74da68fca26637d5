#include "body/closed_surface.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

#include "body/message_of.h"
#include "body/solids.h"
#include "messages.h"

namespace rotatebook::body {
namespace {

using testing::boxMesh;
using testing::messageOf;

std::string judged(const TriangleMesh& mesh) {
  return messageOf([&] { requireClosed(welded(mesh)); });
}

TEST(ClosedSurface, IsThatOfEachSolid) {
  EXPECT_EQ(judged(boxMesh(1, 2, 3)), "accepted");
  EXPECT_EQ(judged(testing::tetrahedronMesh()), "accepted");
  EXPECT_EQ(judged(testing::prismMesh(7, 1, 1)), "accepted");
  EXPECT_EQ(judged(testing::ballMesh(5, 8)), "accepted");
}

// 12 meshes with a hole each.
TEST(ClosedSurface, HasNoHoleWhereATriangleIsMissing) {
  for (std::size_t i = 0; i < 12; ++i) {
    TriangleMesh mesh = boxMesh(1, 2, 3);
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_MESSAGE(judged(mesh)) << i;
  }
}

// 12 meshes with a triangle that faces inward.
TEST(ClosedSurface, FacesOutwardWithAllItsTriangles) {
  for (std::size_t i = 0; i < 12; ++i) {
    TriangleMesh mesh = boxMesh(1, 2, 3);
    std::swap(mesh.triangles[i][0], mesh.triangles[i][1]);
    EXPECT_MESSAGE(judged(mesh)) << i;
  }
}

// 12 meshes with a triangle twice.
TEST(ClosedSurface, HasNoTriangleTwice) {
  for (std::size_t i = 0; i < 12; ++i) {
    TriangleMesh mesh = boxMesh(1, 2, 3);
    mesh.triangles.push_back(mesh.triangles[i]);
    EXPECT_EQ(judged(mesh),
              "triangles " + std::to_string(i + 1) + " and 13 are the same; take one of them away");
  }
}

// 12 meshes with a corner twice in a triangle.
TEST(ClosedSurface, HasTrianglesOfThreeCorners) {
  for (std::size_t i = 0; i < 12; ++i) {
    TriangleMesh mesh = boxMesh(1, 2, 3);
    mesh.triangles[i][i % 3] = mesh.triangles[i][(i + 1) % 3];
    EXPECT_MESSAGE(judged(mesh)) << i;
  }
}

TEST(ClosedSurface, HasNoInnerWall) {
  TriangleMesh mesh = boxMesh(1, 1, 1);
  mesh.triangles.push_back({0, 3, 7});
  EXPECT_MESSAGE(judged(mesh));
}

TEST(ClosedSurface, NamesTheEdgeByItsEnds) {
  TriangleMesh mesh = testing::tetrahedronMesh();
  mesh.triangles.pop_back();
  EXPECT_EQ(judged(mesh),
            "the edge from (0, 1, 0) to (1, 0, 0) belongs to triangle 1 alone: the surface is open "
            "there; close the hole");
}

// One of an edge's two triangles is divided in its middle.
TEST(ClosedSurface, HasNoPointOnAnEdge) {
  TriangleMesh mesh = testing::tetrahedronMesh();
  mesh.points.emplace_back(0.5, 0, 0);
  mesh.triangles[1] = {0, 4, 3};
  mesh.triangles.push_back({4, 1, 3});
  EXPECT_MESSAGE(judged(mesh));
}

/// Returns the mesh with its points in the opposite order.
TriangleMesh turnedRound(TriangleMesh mesh) {
  const auto last = static_cast<std::uint32_t>(mesh.points.size() - 1);
  std::reverse(mesh.points.begin(), mesh.points.end());
  for (auto& triangle : mesh.triangles)
    for (std::uint32_t& point : triangle) point = last - point;
  return mesh;
}

// The sides of one edge are divided at other places, so that each lies on the other's edge.
TEST(ClosedSurface, HasNoEndOfAnEdgeOnAnother) {
  TriangleMesh mesh = testing::tetrahedronMesh();
  mesh.points.emplace_back(0.375, 0, 0);
  mesh.points.emplace_back(0.5, 0, 0);
  mesh.triangles[1] = {0, 4, 3};
  mesh.triangles.push_back({4, 1, 3});
  for (auto& triangle : mesh.triangles) {  // the other side of the edge from 0 to 1
    for (std::size_t i = 0; i < 3; ++i) {
      if (triangle[i] != 1 || triangle[(i + 1) % 3] != 0) continue;
      const std::uint32_t opposite = triangle[(i + 2) % 3];
      triangle = {1, 5, opposite};
      mesh.triangles.push_back({5, 0, opposite});
      break;
    }
  }
  ASSERT_EQ(mesh.triangles.size(), 6U);
  for (const TriangleMesh& one : {mesh, turnedRound(mesh)}) {
    EXPECT_MESSAGE(judged(one));
  }
}

// Two points that should be one, with an edge between them.
TEST(ClosedSurface, HasNoPointsSoNearEachOther) {
  TriangleMesh mesh = testing::tetrahedronMesh();
  mesh.points.emplace_back(1e-7, 0, 0);
  mesh.triangles[0] = {4, 2, 1};
  mesh.triangles.push_back({0, 2, 4});
  EXPECT_MESSAGE(judged(mesh));
}

// In whichever order the points are, the edges of a point on another aren't called a hole.
TEST(ClosedSurface, CallsNoPointOnAnEdgeAHole) {
  TriangleMesh mesh = testing::tetrahedronMesh();
  mesh.points.emplace_back(0.5, 0, 0);
  mesh.triangles[1] = {0, 4, 3};
  mesh.triangles.push_back({4, 1, 3});
  EXPECT_MESSAGE(judged(mesh));
  EXPECT_MESSAGE(judged(turnedRound(mesh)));
  // Half of the divided triangle is missing, too
  mesh.triangles.pop_back();
  EXPECT_MESSAGE(judged(mesh));
}

// Triangles of a hundred-thousandth of the mesh, one of which is missing.
TEST(ClosedSurface, CallsASmallHoleAHole) {
  for (const double size : {1e-2, 1e-3, 1e-4}) {
    TriangleMesh mesh = testing::tetrahedronMesh();
    TriangleMesh small = testing::tetrahedronMesh();
    for (auto& point : small.points) point = 5 * Eigen::Vector3d::Ones() + size * point;
    small.triangles.pop_back();
    append(small, mesh);
    EXPECT_MESSAGE(judged(mesh)) << size;
  }
}

// 12 boxes with a face doubled, back to back: the second one is too many.
TEST(ClosedSurface, HasNoTriangleOnTheBackOfAnother) {
  for (std::size_t i = 0; i < 12; ++i) {
    TriangleMesh mesh = boxMesh(1, 2, 3);
    const auto [a, b, c] = mesh.triangles[i];
    mesh.triangles.push_back({a, c, b});
    EXPECT_EQ(judged(mesh), "triangles " + std::to_string(i + 1) +
                                " and 13 lie on each other and face opposite ways; take triangle "
                                "13 away");
    mesh.triangles.pop_back();
    EXPECT_EQ(judged(mesh), "accepted");
  }
}

TEST(ClosedSurface, NeedsTriangles) {
  EXPECT_MESSAGE(judged({}));
  EXPECT_MESSAGE(judged({{{0, 0, 0}}, {}}));
}

// 9 meshes with a coordinate that is no number.
TEST(Welding, RefusesCoordinatesThatArentFinite) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double number : {std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity}) {
    for (int axis = 0; axis < 3; ++axis) {
      TriangleMesh mesh = boxMesh(1, 1, 1);
      mesh.points[6][axis] = number;
      EXPECT_MESSAGE(judged(mesh));
    }
  }
}

TEST(Welding, RefusesPointsThatDontExist) {
  for (std::size_t i = 0; i < 12; ++i) {
    TriangleMesh mesh = boxMesh(1, 1, 1);
    mesh.triangles[i][2] = 8;
    EXPECT_MESSAGE(judged(mesh));
  }
}

TEST(Welding, JoinsEqualPointsAlone) {
  TriangleMesh soup;
  const TriangleMesh box = boxMesh(1, 2, 3);
  for (const auto& triangle : box.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (const std::uint32_t point : triangle) soup.points.push_back(box.points[point]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_EQ(welded(soup).points.size(), 8U);
  EXPECT_EQ(judged(soup), "accepted");
  soup.points[0].x() += 1e-16;
  EXPECT_EQ(welded(soup).points.size(), 9U) << "there is no tolerance";
  EXPECT_MESSAGE(judged(soup));
}

TEST(Welding, TakesBothZerosForOne) {
  TriangleMesh mesh = testing::tetrahedronMesh();
  mesh.points.emplace_back(-0.0, 0.0, -0.0);
  mesh.triangles[0][0] = 4;
  EXPECT_EQ(welded(mesh).points.size(), 4U);
  EXPECT_EQ(judged(mesh), "accepted");
}

}  // namespace
}  // namespace rotatebook::body
