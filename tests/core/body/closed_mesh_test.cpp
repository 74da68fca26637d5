#include "body/closed_mesh.h"

#include <chrono>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "body/closed_surface.h"
#include "body/mass_properties.h"
#include "body/message_of.h"
#include "body/near_points.h"
#include "body/solids_apart.h"
#include "messages.h"

namespace rotatebook::body {
namespace {

using Eigen::Vector3d;
using ::testing::AllOf;
using testing::ballMesh;
using testing::boxMesh;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::messageOf;
using testing::movedTo;
using testing::soupOf;

struct Closed {
  Surface surface;
  Closing closing;
};

Closed closed(const TriangleMesh& mesh) {
  Closed result{{.mesh = mesh}, {}};
  result.closing = closeSurface(result.surface);
  return result;
}

// The same corner is written by several triangles with other last digits, near and far from 0.
TEST(ClosedMesh, TakesPointsThatAreNearEachOtherForOne) {
  for (const Vector3d& place : {Vector3d(0, 0, 0), Vector3d(100, -7, 1e3)}) {
    const auto [surface, closing] = closed(soupOf(movedTo(boxMesh(1, 2, 3), place), 3e-10));
    EXPECT_EQ(surface.mesh.points.size(), 8U);
    const MassProperties found = massPropertiesOf(surface.mesh, 1);
    EXPECT_NEAR(found.volume, 6, 1e-8);                             // measured 8.7e-10
    EXPECT_NEAR(found.inertia(0, 0), 6 * (4 + 9) / 12.0, 1e-7);     // measured 1.9e-9
    EXPECT_LT((found.centre - place).cwiseAbs().maxCoeff(), 1e-9);  // measured 1.3e-10
    EXPECT_THAT(
        closing.notes,
        ElementsAre(AllOf(HasSubstr("28 points are taken as others that lie "),
                          HasSubstr("e-10 or less from them"), HasSubstr("the mesh is 3 long"))));
  }
}

TEST(ClosedMesh, TakesNothingAwayWhereNothingIs) {
  TriangleMesh inward = boxMesh(0.5, 0.5, 0.5);
  for (auto& triangle : inward.triangles) std::swap(triangle[1], triangle[2]);
  const auto withBox = [&](const Vector3d& place) {
    TriangleMesh both = boxMesh(1, 2, 3);
    append(movedTo(inward, place), both);
    return both;
  };
  const auto box = boxAround(boxMesh(1, 2, 3).points);
  const auto other = boxAround(inward.points);
  // In the middle, and flush with a side
  const Vector3d within = (box.low + box.high) / 2 - (other.low + other.high) / 2;
  const Vector3d flush(box.high.x() - other.high.x(), within.y(), within.z());
  for (const Vector3d& place : {within, flush})
    EXPECT_NEAR(massPropertiesOf(closed(withBox(place)).surface.mesh, 1).volume, 6 - 0.125, 1e-12);
  for (const double apart : {0.1, 5.0}) {
    EXPECT_EQ(messageOf([&] { closed(withBox(flush + Vector3d(apart, 0, 0))); }),
              "the closed surface of triangle 13 faces inward, and is in no other from which it "
              "could take away; turn its triangles' corners round");
  }
  // All inward: the whole is inside out, which is said where its volume is.
  EXPECT_EQ(closed(inward).surface.mesh.triangles.size(), 12U);
}

TEST(ClosedMesh, DoesntJoinPointsThatAreFurtherApart) {
  EXPECT_MESSAGE(messageOf([] { closed(soupOf(boxMesh(1, 2, 3), 3e-7)); }));
}

// Two points at a hundredth of the distance at which others become one.
TEST(ClosedMesh, KeepsAllBitsOfWhatIsClosed) {
  TriangleMesh mesh = boxMesh(1, 2, 3);
  const Vector3d near = mesh.points[0] + Vector3d(1e-11, 0, 0);
  const auto added = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.push_back(near);
  // Divide the edge from corner 0 of a triangle, and of its neighbour
  const auto [a, b, c] = mesh.triangles[0];
  ASSERT_EQ(a, 0U);
  for (auto& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = triangle[i], to = triangle[(i + 1) % 3];
      if ((from != a || to != b) && (from != b || to != a)) continue;
      const std::uint32_t opposite = triangle[(i + 2) % 3];
      triangle = {from, added, opposite};
      mesh.triangles.push_back({added, to, opposite});
      break;
    }
  }
  ASSERT_TRUE(isClosed(mesh));
  const auto [surface, closing] = closed(mesh);
  EXPECT_EQ(surface.mesh.points, welded(mesh).points);
  EXPECT_EQ(surface.mesh.triangles, welded(mesh).triangles);
  EXPECT_THAT(closing.notes, IsEmpty());
  EXPECT_THAT(closing.numbers, IsEmpty());
}

// 1000 points in a row, 0.4 of the distance apart: each third begins anew.
TEST(NearPoints, DontCreepTogetherInAChain) {
  constexpr std::size_t kCount = 1000;
  TriangleMesh mesh{{{-1, 0, 0}, {0, 0, 0}}, {}};
  for (std::size_t i = 1; i < kCount; ++i)
    mesh.points.emplace_back(0.4 * kNearPoints * static_cast<double>(i), 0, 0);
  for (std::uint32_t i = 1; i < kCount; ++i) mesh.triangles.push_back({0, i, i + 1});
  const JoinedPoints joined = joinNearPoints(mesh);
  EXPECT_LE(joined.distance, kNearPoints);                              // measured 0.8 of it
  EXPECT_NEAR(static_cast<double>(joined.count), kCount * 2.0 / 3, 2);  // measured 0.67
  EXPECT_EQ(mesh.triangles.back()[0], 0U);
  EXPECT_GT(mesh.triangles.back()[1], kCount - 5);
}

TEST(NearPoints, TakeTimeInProportion) {
  const TriangleMesh soup = soupOf(ballMesh(250, 400), 1e-12);  // 199,200 triangles
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(closed(soup).surface.mesh.points.size(), 249U * 400 + 2);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  EXPECT_LT(seconds.count(), 30);  // measured 0.19
}

TEST(ClosedMesh, LeavesOutTrianglesWithACornerTwice) {
  TriangleMesh mesh = boxMesh(1, 2, 3);
  mesh.points.emplace_back(50, 0, 0);  // of such a triangle alone
  mesh.triangles.insert(mesh.triangles.begin(), {3, 8, 3});
  mesh.triangles.push_back({1, 1, 1});
  const auto [surface, closing] = closed(mesh);
  EXPECT_EQ(surface.mesh.triangles.size(), 12U);
  EXPECT_EQ(surface.mesh.points.size(), 8U);
  EXPECT_EQ(massPropertiesOf(surface.mesh, 1).volume, 6);
  EXPECT_THAT(closing.notes, ElementsAre("2 triangles have a corner twice, and are left out"));
  EXPECT_EQ(closing.numberOf(0), 1U);
  EXPECT_EQ(closing.numberOf(11), 12U);
}

TEST(ClosedMesh, KeepsTheLookOfWhatIsLeft) {
  Surface surface{.mesh = boxMesh(1, 2, 3), .materials = {{}, {}}};
  surface.mesh.triangles.insert(surface.mesh.triangles.begin() + 4, {3, 3, 5});
  for (std::uint32_t i = 0; i < 13; ++i) {
    surface.materialOf.push_back(i < 5 ? 0 : 1);
    surface.texCoords.push_back({Eigen::Vector2f(i, 0), {0, 0}, {0, 0}});
  }
  closeSurface(surface);
  EXPECT_THAT(surface.materialOf, ElementsAre(0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1));
  ASSERT_EQ(surface.texCoords.size(), 12U);
  EXPECT_EQ(surface.texCoords[4][0].x(), 5);
}

TEST(ClosedMesh, NamesTrianglesByTheirNumbersInTheFile) {
  TriangleMesh mesh = boxMesh(1, 2, 3);
  mesh.triangles.insert(mesh.triangles.begin(), {3, 3, 4});
  mesh.triangles.pop_back();
  const std::string said = messageOf([&] { closed(mesh); });
  EXPECT_MESSAGE(said);
  mesh = boxMesh(1, 2, 3);
  mesh.triangles.insert(mesh.triangles.begin(), {3, 3, 4});
  std::swap(mesh.triangles[12][0], mesh.triangles[12][1]);
  EXPECT_MESSAGE(messageOf([&] { closed(mesh); }));
}

TEST(ClosedMesh, SaysThatNoTriangleHasAnArea) {
  EXPECT_EQ(messageOf([] {
              closed({{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}, {1, 1, 0}}});
            }),
            "each of its 2 triangles has a corner twice, and no area; export it again");
}

}  // namespace
}  // namespace rotatebook::body
