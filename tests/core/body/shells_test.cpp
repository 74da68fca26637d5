#include "body/shells.h"

#include <gtest/gtest.h>

#include "body/closed_surface.h"
#include "body/lattice.h"
#include "body/mass_properties.h"
#include "body/message_of.h"
#include "body/self_crossing.h"
#include "body/solids_apart.h"
#include "messages.h"

namespace rotatebook::body {
namespace {

using Eigen::Vector3d;
using testing::boxMesh;
using testing::insideOut;
using testing::messageOf;
using testing::together;

/// Two cubes of the edge 2, as one welded mesh, and their mass properties in closed form.
struct Pair {
  TriangleMesh mesh;
  Vector3d place;

  explicit Pair(const Vector3d& apart)
      : mesh(welded(together(boxMesh(2, 2, 2), boxMesh(2, 2, 2), apart))), place(apart) {}

  void expectProperties() const {
    ASSERT_EQ(messageOf([this] { requireClosed(mesh); }), "accepted") << place.transpose();
    const MassProperties found = massPropertiesOf(mesh, 1);
    EXPECT_DOUBLE_EQ(found.volume, 16);
    EXPECT_LT((found.centre - place / 2).norm(), 1e-15);  // measured 0
    // 8 (4 + 4) / 12 each, and the distances of their centres to the common one
    const Eigen::Matrix3d apart =
        4 * (place.squaredNorm() * Eigen::Matrix3d::Identity() - place * place.transpose());
    const Eigen::Matrix3d expected = 2 * 16 / 3.0 * Eigen::Matrix3d::Identity() + apart;
    EXPECT_LT((found.inertia - expected).norm(), 1e-13) << place.transpose();  // measured 1.2e-14
  }
};

// Along an edge, in a corner, with a face each, and none.
TEST(Shells, OfBodiesThatTouchAreTheirOwn) {
  for (const Vector3d& place : {Vector3d(2, 2, 0), Vector3d(2, 2, 2), Vector3d(2, 0, 0),
                                Vector3d(0, -2, 0), Vector3d(2, 0, -2), Vector3d(3, 0, 0)}) {
    const Pair pair(place);
    pair.expectProperties();
    const Shells shells = shellsOf(pair.mesh);
    EXPECT_EQ(shells.count, 2U) << place.transpose();
    EXPECT_FALSE(shells.overlap) << place.transpose();
    EXPECT_FALSE(findSelfCrossing(pair.mesh)) << place.transpose();
  }
}

// 3 x 3 x 3 cubes like a chessboard: 14 that touch along 36 edges inside alone.
TEST(Shells, OfVoxelsAreCounted) {
  TriangleMesh all;
  for (int i = 0; i < 27; i += 2)
    all = together(all, boxMesh(1, 1, 1), {i % 3 * 1.0, i / 3 % 3 * 1.0, i / 9 * 1.0});
  all = welded(all);
  ASSERT_TRUE(isClosed(all));
  EXPECT_DOUBLE_EQ(massPropertiesOf(all, 1).volume, 14);
  EXPECT_EQ(shellsOf(all).count, 14U);
  EXPECT_FALSE(shellsOf(all).overlap);
  EXPECT_FALSE(findSelfCrossing(all));
}

TEST(Shells, AreThoseOfHollowBodies) {
  const TriangleMesh hollow =
      welded(together(boxMesh(2, 2, 2), insideOut(boxMesh(1, 1, 1)), {0, 0, 0}));
  EXPECT_EQ(shellsOf(hollow).count, 2U);
  EXPECT_FALSE(shellsOf(hollow).overlap);
  EXPECT_DOUBLE_EQ(massPropertiesOf(hollow, 1).volume, 7);
}

// Two boxes of one height that stand on the same edge, one within the other.
TEST(Shells, OverlapWhereSomethingIsEnclosedTwice) {
  const TriangleMesh nested = welded(together(boxMesh(2, 2, 2), boxMesh(1, 1, 2), {-0.5, -0.5, 0}));
  ASSERT_TRUE(isClosed(nested));
  EXPECT_EQ(shellsOf(nested).count, 2U);
  const auto overlap = shellsOf(nested).overlap;
  ASSERT_TRUE(overlap);
  EXPECT_LT((*overlap)[0], 12U);
  EXPECT_GE((*overlap)[1], 12U);
}

TEST(Shells, OverlapWhereNothingIsTakenAway) {
  const TriangleMesh mesh =
      welded(together(boxMesh(2, 2, 2), insideOut(boxMesh(1, 1, 2)), {1.5, 1.5, 0}));
  ASSERT_TRUE(isClosed(mesh));
  EXPECT_TRUE(shellsOf(mesh).overlap);
  EXPECT_DOUBLE_EQ(massPropertiesOf(mesh, 1).volume, 6);
}

TEST(ClosedSurface, IsntASheetWithTwoFaces) {
  TriangleMesh sheet{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {2, 1, 3}}};
  append(insideOut(sheet), sheet);
  sheet = welded(sheet);
  EXPECT_FALSE(isClosed(sheet));
  EXPECT_MESSAGE(messageOf([&] { requireClosed(sheet); }));
}

// A face with both sides that stands out of a box, or is a wall in it, has no volume.
TEST(ClosedSurface, MayHaveWallsOfTwoFaces) {
  for (const Vector3d& tip : {Vector3d(3, 3, 3), Vector3d(0, 0, 0)}) {
    TriangleMesh box = boxMesh(2, 2, 2);
    box.points.push_back(tip);
    box.triangles.insert(box.triangles.end(), {{7, 3, 8}, {3, 7, 8}});
    ASSERT_EQ(messageOf([&] { requireClosed(box); }), "accepted");
    EXPECT_DOUBLE_EQ(massPropertiesOf(box, 1).volume, 8);
    EXPECT_EQ(shellsOf(box).count, tip.x() > 0 ? 2U : 1U);
    EXPECT_FALSE(shellsOf(box).overlap);
  }
}

// The whole box twice, whose edges are used alike both ways.
TEST(ClosedSurface, IsntTheSameBodyTwice) {
  const TriangleMesh twice = welded(together(boxMesh(1, 2, 3), boxMesh(1, 2, 3), {0, 0, 0}));
  EXPECT_MESSAGE(messageOf([&] { requireClosed(twice); }));
}

// A face with both sides goes through the edge along which two cubes touch, outside both.
TEST(SelfCrossing, IsntBetweenBodiesThatTouch) {
  TriangleMesh mesh = together(boxMesh(2, 2, 2), boxMesh(2, 2, 2), {2, 2, 0});
  const TriangleMesh sheet{{{0.5, 1.5, 0.1}, {1.5, 0.5, 0.1}, {1.5, 0.5, 0.3}},
                           {{0, 1, 2}, {2, 1, 0}}};
  append(sheet, mesh);
  mesh = welded(mesh);
  ASSERT_TRUE(isClosed(mesh));
  EXPECT_FALSE(findSelfCrossing(mesh));
}

// Points between cubes that touch are inside one of them, where the line goes through their edge.
TEST(Lattice, CountsBodiesThatTouchOnce) {
  for (const Vector3d& place : {Vector3d(2, 0, 0), Vector3d(0, 2, 0), Vector3d(2, 2, 0)}) {
    const Pair pair(place);
    const auto [low, high] = boxAround(pair.mesh.points);
    for (const int winding : windingNumbers(pair.mesh, latticeIn(low, high, 9))) {
      EXPECT_GE(winding, 0);
      EXPECT_LE(winding, 1);
    }
  }
}

}  // namespace
}  // namespace rotatebook::body
