#include "geometry/body_mesh.h"

#include <array>
#include <cstddef>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "body/shape.h"

namespace rotatebook::geometry {
namespace {

body::TriangleMesh meshOf(const char* shape, std::array<double, 3> lengths) {
  return body::findShape(shape)->solid(lengths).surface;
}

Eigen::Vector3d worldNormal(const MeshVertex& vertex, const Eigen::Vector3d& size) {
  return vertex.normal.cast<double>().cwiseQuotient(size).normalized();
}

TEST(BodyMesh, OfACuboidHasANormalForEachSide) {
  const Eigen::Vector3d size(0.2, 0.3, 0.05);
  const Mesh mesh = makeBodyMesh({.mesh = meshOf("box", {0.2, 0.3, 0.05})}, size);
  for (const MeshVertex& vertex : mesh.vertices) {
    EXPECT_NEAR(vertex.normal.cwiseAbs().maxCoeff(), 1, 1e-6);  // measured 0
    EXPECT_GT((vertex.position - Eigen::Vector3f::Constant(0.5F)).dot(vertex.normal), 0);
  }
  // Six sides: four with 4 corners, and the caps with one in the middle
  EXPECT_EQ(mesh.vertices.size(), 26U);
}

TEST(BodyMesh, OfASmoothSurfaceSharesItsVertices) {
  const Eigen::Vector3d size(0.2, 0.14, 0.1);
  const body::TriangleMesh surface = meshOf("ellipsoid", {0.2, 0.14, 0.1});
  const Mesh mesh = makeBodyMesh({.mesh = surface}, size);
  EXPECT_EQ(mesh.vertices.size(), surface.points.size());
  EXPECT_EQ(mesh.parts.at(0).triangles.size(), 3 * surface.triangles.size());
  for (const MeshVertex& vertex : mesh.vertices) {
    const Eigen::Vector3d unit = vertex.position.cast<double>() - Eigen::Vector3d::Constant(0.5);
    const Eigen::Vector3d exact = unit.cwiseQuotient(size).normalized();
    EXPECT_GT(worldNormal(vertex, size).dot(exact), 0.999);  // measured 0.99998
  }
}

TEST(BodyMesh, GivesNeighbouringSidesDifferentNumbers) {
  const body::TriangleMesh box = meshOf("box", {1, 1, 1});
  const Mesh mesh = makeBodyMesh({.mesh = box}, {1, 1, 1});
  std::set<float> atCorner;
  for (const MeshVertex& vertex : mesh.vertices) {
    EXPECT_GE(vertex.surfaceId, 1);
    EXPECT_LE(vertex.surfaceId, kMaxSurfaceId);
    if (vertex.position == Eigen::Vector3f::Ones()) atCorner.insert(vertex.surfaceId);
  }
  EXPECT_EQ(atCorner.size(), 3U);
}

TEST(BodyMesh, HasAPartForEachMaterial) {
  const std::array<double, 4> lengths{0.07, 0.15, 0.008, 0.01};
  const body::Surface phone = body::findShape("phone")->look(lengths);
  const Mesh mesh = makeBodyMesh(phone, {0.07, 0.15, 0.008});
  ASSERT_EQ(mesh.parts.size(), phone.materials.size());
  std::size_t corners = 0;
  for (const MeshPart& part : mesh.parts) corners += part.triangles.size();
  EXPECT_EQ(corners, 3 * phone.mesh.triangles.size());
}

TEST(BodyMesh, KnowsPartsOfOneMaterial) {
  body::Surface surface{.mesh = meshOf("box", {1, 1, 1})};
  surface.materials = {{.roughness = 0.2F}, {}, {.roughness = 0.2F}, {}};
  std::vector<std::size_t> alike;
  for (const MeshPart& part : makeBodyMesh(surface, {1, 1, 1}).parts) alike.push_back(part.alike);
  EXPECT_EQ(alike, (std::vector<std::size_t>{0, 1, 0, 1}));
}

TEST(BodyMesh, TurnsTextureCoordinatesUp) {
  body::Surface surface{.mesh = meshOf("box", {1, 1, 1})};
  surface.texCoords.assign(surface.mesh.triangles.size(), {{{0, 0.25F}, {1, 0.25F}, {1, 1}}});
  const Mesh mesh = makeBodyMesh(surface, {1, 1, 1});
  EXPECT_EQ(mesh.vertices.at(mesh.parts[0].triangles[0]).texCoord, Eigen::Vector2f(0, 0.75F));
}

}  // namespace
}  // namespace rotatebook::geometry
