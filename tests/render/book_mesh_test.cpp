#include "render/book_mesh.h"

#include <algorithm>
#include <map>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace rotatebook::render {
namespace {

// Calls check(a, b, c) with the vertices of each triangle of `part`.
template <typename Check>
void forEachTriangle(const BookMesh& mesh, std::size_t part, const Check& check) {
  const std::vector<std::uint32_t>& indices = mesh.triangles[part];
  ASSERT_EQ(indices.size() % 3, 0U);
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    check(mesh.vertices.at(indices[i]), mesh.vertices.at(indices[i + 1]),
          mesh.vertices.at(indices[i + 2]));
  }
}

bool hasVertexAt(const BookMesh& mesh, const Eigen::Vector3f& place) {
  return std::any_of(mesh.vertices.begin(), mesh.vertices.end(),
                     [&](const BookVertex& vertex) { return vertex.place == place; });
}

TEST(BookMesh, HasTrianglesInEachPart) {
  for (const auto& triangles : makeBookMesh().triangles) EXPECT_FALSE(triangles.empty());
}

TEST(BookMesh, LiesInTheUnitCube) {
  for (const BookVertex& vertex : makeBookMesh().vertices) {
    EXPECT_GE(vertex.place.minCoeff(), 0);
    EXPECT_LE(vertex.place.maxCoeff(), 1);
  }
}

TEST(BookMesh, ReachesTheEightCorners) {
  const BookMesh mesh = makeBookMesh();
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3i place(i & 1, i >> 1 & 1, i >> 2 & 1);
    EXPECT_TRUE(hasVertexAt(mesh, place.cast<float>())) << "corner " << i;
  }
}

TEST(BookMesh, HasTrianglesCounterClockwiseFromOutside) {
  const BookMesh mesh = makeBookMesh();
  for (std::size_t part = 0; part < kBookPartCount; ++part) {
    forEachTriangle(mesh, part, [&](const BookVertex& a, const BookVertex& b, const BookVertex& c) {
      const Eigen::Vector3f across = (b.place - a.place).cross(c.place - a.place);
      EXPECT_GT(across.dot(a.normal), 0) << "part " << part;
      EXPECT_NEAR(across.normalized().dot(a.normal), 1, 1e-6) << "part " << part;
      EXPECT_EQ(a.normal, b.normal);
      EXPECT_EQ(a.normal, c.normal);
    });
  }
}

// Normals are outward: no vertex of a cover board lies in front of one of its outer sides.
TEST(BookMesh, HasOutwardNormalsOnTheCubesSides) {
  for (const BookVertex& vertex : makeBookMesh().vertices) {
    EXPECT_EQ(vertex.normal.lpNorm<1>(), 1);
    for (int axis = 0; axis < 3; ++axis) {
      if (vertex.normal[axis] == 0) continue;
      if (vertex.place[axis] == 0) {
        EXPECT_EQ(vertex.normal[axis], -1);
      }
      if (vertex.place[axis] == 1) {
        EXPECT_EQ(vertex.normal[axis], 1);
      }
    }
  }
}

// Area of `part`'s triangles that lie in the cube's side `sign` along `axis`.
float areaOnSide(const BookMesh& mesh, BookPart part, int axis, int sign) {
  float area = 0;
  const float level = sign > 0 ? 1.0F : 0.0F;
  forEachTriangle(mesh, static_cast<std::size_t>(part),
                  [&](const BookVertex& a, const BookVertex& b, const BookVertex& c) {
                    if (a.normal[axis] != static_cast<float>(sign)) return;
                    if (a.place[axis] != level) return;
                    area += (b.place - a.place).cross(c.place - a.place).norm() / 2;
                  });
  return area;
}

float areaOnSide(const BookMesh& mesh, int axis, int sign) {
  float area = 0;
  for (std::size_t part = 0; part < kBookPartCount; ++part) {
    area += areaOnSide(mesh, static_cast<BookPart>(part), axis, sign);
  }
  return area;
}

TEST(BookMesh, CoversFrontBackAndSpineWhole) {
  const BookMesh mesh = makeBookMesh();
  EXPECT_NEAR(areaOnSide(mesh, BookPart::Front, 2, 1), 1, 1e-6);
  EXPECT_NEAR(areaOnSide(mesh, BookPart::Back, 2, -1), 1, 1e-6);
  EXPECT_NEAR(areaOnSide(mesh, BookPart::Spine, 0, -1), 1, 1e-6);
}

// Which one of two faces in one place is seen would be up to rounding.
TEST(BookMesh, HasOneFaceInEachPlaceOfTheCubesSides) {
  constexpr float kBoards = 2 * 0.06F, kSpine = 0.016F;
  const BookMesh mesh = makeBookMesh();
  EXPECT_NEAR(areaOnSide(mesh, 2, 1), 1, 1e-6);
  EXPECT_NEAR(areaOnSide(mesh, 2, -1), 1, 1e-6);
  EXPECT_NEAR(areaOnSide(mesh, 0, -1), 1, 1e-6);
  EXPECT_NEAR(areaOnSide(mesh, 0, 1), kBoards, 1e-6);
  EXPECT_NEAR(areaOnSide(mesh, 1, 1), kBoards + kSpine * (1 - kBoards), 1e-6);
  EXPECT_NEAR(areaOnSide(mesh, 1, -1), kBoards + kSpine * (1 - kBoards), 1e-6);
}

TEST(BookMesh, LightsWhatItSeesOfTheSurroundings) {
  float darkest = 1;
  for (const BookVertex& vertex : makeBookMesh().vertices) {
    EXPECT_GT(vertex.openness, 0);
    EXPECT_LE(vertex.openness, 1);
    darkest = std::min(darkest, vertex.openness);
  }
  EXPECT_LT(darkest, 1) << "nothing is shaded";
}

}  // namespace
}  // namespace rotatebook::render
