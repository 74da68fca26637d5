#include "geometry/book_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace rotatebook::geometry {
namespace {

// Calls check(a, b, c) with the vertices of each triangle of `part`.
template <typename Check>
void forEachTriangle(const Mesh& mesh, std::size_t part, const Check& check) {
  const std::vector<std::uint32_t>& indices = mesh.parts[part].triangles;
  ASSERT_EQ(indices.size() % 3, 0U);
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    check(mesh.vertices.at(indices[i]), mesh.vertices.at(indices[i + 1]),
          mesh.vertices.at(indices[i + 2]));
  }
}

const Eigen::Vector3f kBookSize(187.8F, 290.85F, 50);  // mm

/// The normal in space of a covector of the unit cube, which is `perLength` [1/mm] along the axes.
Eigen::Vector3f worldNormal(const Eigen::Vector3f& covector, const Eigen::Vector3f& perLength) {
  return covector.cwiseProduct(perLength).normalized();
}

class BookMesh : public ::testing::TestWithParam<MeshDetail> {};

INSTANTIATE_TEST_SUITE_P(Details, BookMesh, ::testing::Values(MeshDetail::Full, MeshDetail::Small));

std::size_t triangleCount(MeshDetail detail) {
  std::size_t count = 0;
  for (const MeshPart& part : makeBookMesh(detail).parts) count += part.triangles.size() / 3;
  return count;
}

TEST(SmallBookMesh, HasAFifthOfTheTriangles) {
  EXPECT_LT(5 * triangleCount(MeshDetail::Small), triangleCount(MeshDetail::Full));  // 540 of 2828
}

TEST_P(BookMesh, HasTrianglesInEachPart) {
  for (const MeshPart& part : makeBookMesh(GetParam()).parts) EXPECT_FALSE(part.triangles.empty());
}

TEST_P(BookMesh, LiesInTheUnitCube) {
  for (const MeshVertex& vertex : makeBookMesh(GetParam()).vertices) {
    EXPECT_GE(vertex.position.minCoeff(), 0);
    EXPECT_LE(vertex.position.maxCoeff(), 1);
  }
}

// So that it's as large as its corners say.
TEST_P(BookMesh, TouchesEachSideOfTheCube) {
  Eigen::Vector3f low(1, 1, 1), high(0, 0, 0);
  for (const MeshVertex& vertex : makeBookMesh(GetParam()).vertices) {
    low = low.cwiseMin(vertex.position);
    high = high.cwiseMax(vertex.position);
  }
  constexpr float kBound = 1e-6F;  // measured 0, 6e-8
  EXPECT_LT(low.maxCoeff(), kBound);
  EXPECT_GT(high.minCoeff(), 1 - kBound);
}

TEST_P(BookMesh, HasTrianglesCounterClockwiseFromOutside) {
  // A triangle is twisted where the rounding of the rim runs out. measured 0.16
  constexpr float kMinCosine = 0.1F;
  const Mesh mesh = makeBookMesh(GetParam());
  const Eigen::Vector3f perLength = kBookSize.cwiseInverse();
  for (std::size_t part = 0; part < kBookPartCount; ++part) {
    forEachTriangle(mesh, part, [&](const MeshVertex& a, const MeshVertex& b, const MeshVertex& c) {
      const Eigen::Vector3f across =
          worldNormal((b.position - a.position).cross(c.position - a.position), perLength);
      Eigen::Vector3f mean = Eigen::Vector3f::Zero();
      for (const MeshVertex* vertex : {&a, &b, &c}) mean += worldNormal(vertex->normal, perLength);
      EXPECT_GT(across.dot(mean.normalized()), kMinCosine)
          << "part " << part << " at " << a.position.transpose();
    });
  }
}

TEST_P(BookMesh, HasNormalsOfUnitLength) {
  constexpr float kBound = 1e-6F;  // measured 1.2e-7
  for (const MeshVertex& vertex : makeBookMesh(GetParam()).vertices) {
    EXPECT_NEAR(vertex.normal.norm(), 1, kBound);
  }
}

// Area of `part`'s triangles that lie in the cube's side `sign` along `axis`.
float areaOnSide(const Mesh& mesh, BookPart part, int axis, int sign) {
  float area = 0;
  const float level = sign > 0 ? 1.0F : 0.0F;
  forEachTriangle(mesh, static_cast<std::size_t>(part),
                  [&](const MeshVertex& a, const MeshVertex& b, const MeshVertex& c) {
                    if (a.normal[axis] != static_cast<float>(sign)) return;
                    if (a.position[axis] != level) return;
                    area += (b.position - a.position).cross(c.position - a.position).norm() / 2;
                  });
  return area;
}

float areaOnSide(const Mesh& mesh, int axis, int sign) {
  float area = 0;
  for (std::size_t part = 0; part < kBookPartCount; ++part) {
    area += areaOnSide(mesh, static_cast<BookPart>(part), axis, sign);
  }
  return area;
}

// But for hinges and roundings, which lie within the cube.
TEST_P(BookMesh, CoversFrontAndBack) {
  constexpr float kMin = 0.93F;  // measured 0.936
  const Mesh mesh = makeBookMesh(GetParam());
  EXPECT_GT(areaOnSide(mesh, BookPart::Front, 2, 1), kMin);
  EXPECT_GT(areaOnSide(mesh, BookPart::Back, 2, -1), kMin);
  // The small book's hinges slope in triangles that begin in the side. measured 1.0075
  const float most = GetParam() == MeshDetail::Small ? 1.01F : 1;
  EXPECT_LE(areaOnSide(mesh, 2, 1), most);
  EXPECT_LE(areaOnSide(mesh, 2, -1), most);
}

// Rounding would decide which one of two faces in one place is seen.
TEST_P(BookMesh, HasNoTriangleTwice) {
  const Mesh mesh = makeBookMesh(GetParam());
  std::set<std::vector<float>> seen;
  for (std::size_t part = 0; part < kBookPartCount; ++part) {
    forEachTriangle(mesh, part, [&](const MeshVertex& a, const MeshVertex& b, const MeshVertex& c) {
      const Eigen::Vector3f middle = a.position + b.position + c.position;
      EXPECT_TRUE(seen.insert({middle.x(), middle.y(), middle.z()}).second) << middle.transpose();
    });
  }
}

// It isn't drawn where the leaves hide it: none of it may be beyond them.
TEST_P(BookMesh, HasItsLiningAgainstTheLeaves) {
  const Mesh mesh = makeBookMesh(GetParam());
  Eigen::Vector3f low(1, 1, 1), high(0, 0, 0);
  for (const std::uint32_t index :
       mesh.parts[static_cast<std::size_t>(BookPart::Pages)].triangles) {
    low = low.cwiseMin(mesh.vertices[index].position);
    high = high.cwiseMax(mesh.vertices[index].position);
  }
  // Of the leaves, the spine side and the sides on the boards aren't drawn.
  const Eigen::Vector3f room(0.02F, 1e-6F, 1);
  for (const std::uint32_t index :
       mesh.parts[static_cast<std::size_t>(BookPart::Lining)].triangles) {
    const Eigen::Vector3f& place = mesh.vertices[index].position;
    EXPECT_TRUE((place.array() >= (low - room).array()).all()) << place.transpose();
    EXPECT_LE(place.x(), high.x() + 1e-6F);
    EXPECT_LE(place.y(), high.y() + 1e-6F);
  }
}

// Light must not fall through the case: but for the open sides of the page block every edge of its
// surface has a triangle on either side.
TEST_P(BookMesh, HasAClosedCase) {
  const Mesh mesh = makeBookMesh(GetParam());
  std::map<std::vector<long>, int> edges;
  const auto count = [&](const MeshVertex& from, const MeshVertex& to) {
    const auto key = [](const MeshVertex& a) {
      return std::vector<long>{std::lround(1e5 * a.position.x()), std::lround(1e5 * a.position.y()),
                               std::lround(1e5 * a.position.z())};
    };
    const bool swapped = key(to) < key(from);
    std::vector<long> edge = key(swapped ? to : from);
    for (const long number : key(swapped ? from : to)) edge.push_back(number);
    edges[edge] += swapped ? -1 : 1;
  };
  for (const BookPart part : {BookPart::Front, BookPart::Spine, BookPart::Back, BookPart::Lining}) {
    forEachTriangle(mesh, static_cast<std::size_t>(part),
                    [&](const MeshVertex& a, const MeshVertex& b, const MeshVertex& c) {
                      count(a, b);
                      count(b, c);
                      count(c, a);
                    });
  }
  int open = 0;
  for (const auto& [edge, sum] : edges) open += sum != 0 ? 1 : 0;
  EXPECT_EQ(open, 0) << "of " << edges.size();
}

TEST_P(BookMesh, LightsWhatItSeesOfTheSurroundings) {
  float darkest = 1;
  for (const MeshVertex& vertex : makeBookMesh(GetParam()).vertices) {
    EXPECT_GT(vertex.skyVisibility, 0);
    EXPECT_LE(vertex.skyVisibility, 1);
    darkest = std::min(darkest, vertex.skyVisibility);
  }
  EXPECT_LT(darkest, 1) << "nothing is shaded";
}

}  // namespace
}  // namespace rotatebook::geometry
