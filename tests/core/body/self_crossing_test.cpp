#include "body/self_crossing.h"

#include <chrono>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "body/closed_surface.h"
#include "body/solids.h"

namespace rotatebook::body {
namespace {

using Eigen::Vector3d;
using testing::ballMesh;
using testing::boxMesh;

/// Returns both meshes as one, the second moved.
TriangleMesh weldedTogether(const TriangleMesh& one, TriangleMesh other, const Vector3d& place) {
  for (Vector3d& point : other.points) point += place;
  TriangleMesh both = one;
  const auto first = static_cast<std::uint32_t>(one.points.size());
  both.points.insert(both.points.end(), other.points.begin(), other.points.end());
  for (const auto& [a, b, c] : other.triangles)
    both.triangles.push_back({a + first, b + first, c + first});
  return welded(both);
}

bool crosses(const TriangleMesh& mesh) {
  requireClosed(mesh);
  return findSelfCrossing(mesh).has_value();
}

/// Returns the corner of a coordinate system that no plane of the meshes has.
TriangleMesh turned(TriangleMesh mesh) {
  const Eigen::Matrix3d turn =
      Eigen::Quaterniond(0.8, 0.3, -0.4, 0.33).normalized().toRotationMatrix();
  for (Vector3d& point : mesh.points) point = turn * point + Vector3d(10, -7, 3);
  return mesh;
}

TEST(SelfCrossing, IsntInSolids) {
  for (const TriangleMesh& mesh : {boxMesh(1, 2, 3), testing::tetrahedronMesh(),
                                   testing::prismMesh(7, 1, 1), ballMesh(12, 20)}) {
    EXPECT_FALSE(crosses(mesh));
    EXPECT_FALSE(crosses(turned(mesh)));
  }
}

// Where corners are at round numbers, edges meet the diagonals of faces.
TEST(SelfCrossing, IsWhereBoxesOverlap) {
  const TriangleMesh box = boxMesh(2, 2, 2);
  for (const Vector3d& place : {Vector3d(1, 1, 1), Vector3d(0.3, 0.7, 1.1), Vector3d(-1, 1, 0.5),
                                Vector3d(0.5, 0.25, 1.75)}) {
    EXPECT_TRUE(crosses(weldedTogether(box, box, place))) << place.transpose();
    EXPECT_TRUE(crosses(turned(weldedTogether(box, box, place)))) << place.transpose();
  }
  EXPECT_TRUE(crosses(weldedTogether(box, boxMesh(0.5, 0.5, 5), {0, 0, 0}))) << "a bar through it";
}

TEST(SelfCrossing, IsntWhereBoxesTouch) {
  const TriangleMesh box = boxMesh(2, 2, 2);
  for (const Vector3d& place : {Vector3d(0.5, 0.25, 2), Vector3d(1, 0, 2), Vector3d(2, 2, 0.5),
                                Vector3d(2, 0.5, 0.5), Vector3d(5, 0, 0)})
    EXPECT_FALSE(crosses(weldedTogether(box, box, place))) << place.transpose();
  EXPECT_FALSE(crosses(weldedTogether(box, boxMesh(1, 1, 1), {0, 0, 0}))) << "one within the other";
  EXPECT_FALSE(crosses(weldedTogether(box, boxMesh(1, 1, 1), {0.5, 0.5, 0.5}))) << "in its corner";
}

// An edge that stands on an edge, from corner to corner of the pair of faces.
TEST(SelfCrossing, IsntWhereEdgesTouch) {
  TriangleMesh diamond = boxMesh(2, 2, 2);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(std::acos(-1.0) / 4, Vector3d::UnitX()).toRotationMatrix();
  for (Vector3d& point : diamond.points) point = turn * point;
  const double height = 1 + diamond.points[0].cwiseAbs().maxCoeff();
  EXPECT_FALSE(crosses(weldedTogether(boxMesh(2, 2, 2), diamond, {0, 0.3, height + 1e-9})));
  EXPECT_TRUE(crosses(weldedTogether(boxMesh(2, 2, 2), diamond, {0, 0.3, height - 1e-6})));
}

TEST(SelfCrossing, NamesTheTriangles) {
  TriangleMesh ball = ballMesh(12, 20);
  const auto top = static_cast<std::uint32_t>(ball.points.size() - 2);
  ball.points[top] = {0, 0, -1.5};  // through the other side
  const auto found = findSelfCrossing(ball);
  ASSERT_TRUE(found);
  const auto hasTop = [&](std::size_t triangle) {
    return std::ranges::count(ball.triangles[triangle], top) == 1;
  };
  EXPECT_TRUE(hasTop((*found)[0]) != hasTop((*found)[1]));
  EXPECT_LT((*found)[0], (*found)[1]);
}

// Its point is within the box, its base outside.
TEST(SelfCrossing, IsFoundWhereverASpikeEntersABox) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(-0.8, 0.8);
  for (int i = 0; i < 200; ++i) {
    const TriangleMesh spike{{{share(random), share(random), share(random)},
                              {3 + share(random), share(random), 3.1},
                              {3.1, share(random), 3.3},
                              {3.2, share(random) + 0.9, 3.2}},
                             {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
    EXPECT_TRUE(findSelfCrossing(weldedTogether(boxMesh(2, 2, 2), spike, {0, 0, 0}))) << i;
    EXPECT_FALSE(findSelfCrossing(weldedTogether(boxMesh(2, 2, 2), spike, {2, 2, 2}))) << i;
  }
}

// Slivers around one point, whose boxes all meet.
TEST(SelfCrossing, IsGivenUpWhereAllBoxesMeet) {
  const TriangleMesh star = testing::prismMesh(20'000, 1, 1);
  EXPECT_FALSE(crosses(turned(star)));
}

TEST(SelfCrossing, TakesTimeInProportion) {
  const TriangleMesh ball = ballMesh(250, 400);  // 199,200 triangles
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_FALSE(crosses(ball));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  EXPECT_LT(seconds.count(), 30);  // measured 0.27
}

}  // namespace
}  // namespace rotatebook::body
