#include "render/body/mesh_geometry.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/LU>

namespace rotatebook::render {
namespace {

void describeAttribute(GLuint index, GLint size, std::size_t stride, std::size_t offset) {
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                        reinterpret_cast<const void*>(offset));
}

/// Describes the vertex attributes, numbered as in body.vert.
void describeVertex(std::size_t stride) {
  const auto attribute = [stride](GLuint index, GLint size, std::size_t offset) {
    describeAttribute(index, size, stride, offset);
  };
  attribute(0, 3, offsetof(geometry::MeshVertex, position));
  attribute(1, 3, offsetof(geometry::MeshVertex, normal));
  attribute(2, 2, offsetof(geometry::MeshVertex, texCoord));
  attribute(3, 1, offsetof(geometry::MeshVertex, skyVisibility));
  attribute(4, 1, offsetof(geometry::MeshVertex, surfaceId));
  attribute(5, 3, offsetof(geometry::MeshVertex, away));
}

/// A point of a strip's middle line.
struct StripVertex {
  geometry::MeshVertex vertex;
  Eigen::Vector3f rolledOut;  // x and y in clip space; z is 1.
};

/// Returns how far along the strip a point of its middle line is. [0 to 1]
float shareOf(const geometry::MeshStrip& strip, const geometry::MeshVertex& vertex) {
  const Eigen::Vector3f start = strip.middle.front().position;
  const Eigen::Vector3f line = strip.middle.back().position - start;
  return (vertex.position - start).dot(line) / line.squaredNorm();
}

/// Returns the strip as a row, from the left, of the picture of strips. Of points closer together
/// than a pixel, it takes the outer ones only: a line within one pixel may miss the pixel's middle.
std::vector<StripVertex> rollOut(const geometry::MeshStrip& strip, float y) {
  constexpr float kStep = 0.025F;  // Share of the strip's length.
  std::vector<StripVertex> vertices;
  float before = 0;
  for (std::size_t i = 0; i < strip.middle.size(); ++i) {
    const bool isLast = i + 1 == strip.middle.size();
    const float share = shareOf(strip, strip.middle[i]);
    const float after = isLast ? share : shareOf(strip, strip.middle[i + 1]);
    if (share - before < kStep && after - share < kStep) continue;
    vertices.push_back({strip.middle[i], {2 * share * strip.length - 1, y, 1}});
    before = share;
  }
  vertices.front().rolledOut.x() = -1;
  vertices.back().rolledOut.x() = 2 * strip.length - 1;
  return vertices;
}

template <typename Element>
void upload(GLenum target, const GlBuffer& buffer, const std::vector<Element>& elements) {
  glBindBuffer(target, buffer.name());
  glBufferData(target, static_cast<GLsizeiptr>(elements.size() * sizeof(Element)), elements.data(),
               GL_STATIC_DRAW);
}

/// Returns the Jacobian determinant of the map from the unit cube at each corner, as a share of the
/// largest magnitude. Negative: inside out.
Eigen::Array<double, 8, 1> cornerDeterminants(const body::Cage& cage) {
  Eigen::Array<double, 8, 1> determinants;
  for (int i = 0; i < 8; ++i) {
    Eigen::Matrix3d edges;
    for (int axis = 0; axis < 3; ++axis) {
      const int other = i ^ (1 << axis);
      const double sign = (i & (1 << axis)) != 0 ? 1 : -1;
      edges.col(axis) = sign * (cage.col(i) - cage.col(other));
    }
    determinants[i] = edges.determinant();
  }
  return determinants / std::max(determinants.abs().maxCoeff(), std::numeric_limits<double>::min());
}

}  // namespace

MeshGeometry::MeshGeometry(const geometry::Mesh& mesh) {
  std::vector<std::uint32_t> indices;
  for (const geometry::MeshPart& part : mesh.parts) {
    starts_.push_back(indices.size());
    indices.insert(indices.end(), part.triangles.begin(), part.triangles.end());
  }
  starts_.push_back(indices.size());
  glBindVertexArray(array_.name());
  upload(GL_ARRAY_BUFFER, vertices_, mesh.vertices);
  upload(GL_ELEMENT_ARRAY_BUFFER, indices_, indices);
  describeVertex(sizeof(geometry::MeshVertex));
  if (!mesh.strips.empty()) uploadStrips(mesh.strips);
}

void MeshGeometry::uploadStrips(const std::vector<geometry::MeshStrip>& strips) {
  std::vector<StripVertex> vertices;
  for (std::size_t i = 0; i < strips.size(); ++i) {
    const float y = (2 * static_cast<float>(i) + 1) / static_cast<float>(strips.size()) - 1;
    const std::vector<StripVertex> row = rollOut(strips[i], y);
    rows_.push_back(
        {strips[i].part, static_cast<GLint>(vertices.size()), static_cast<GLsizei>(row.size())});
    vertices.insert(vertices.end(), row.begin(), row.end());
  }
  bindStrips();
  upload(GL_ARRAY_BUFFER, stripVertices_, vertices);
  describeVertex(sizeof(StripVertex));
  describeAttribute(6, 3, sizeof(StripVertex), offsetof(StripVertex, rolledOut));
}

bool MeshGeometry::hasNarrowStrips(std::size_t part,
                                   const std::vector<ScreenStrip>& onScreen) const {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (rows_[i].part == part && onScreen[i].narrow) return true;
  }
  return false;
}

void MeshGeometry::drawStrips(std::size_t part, const std::vector<ScreenStrip>& onScreen) const {
  std::vector<GLint> firsts;
  std::vector<GLsizei> counts;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (rows_[i].part != part || !onScreen[i].narrow) continue;
    firsts.push_back(rows_[i].first);
    counts.push_back(rows_[i].count);
  }
  glMultiDrawArrays(GL_LINE_STRIP, firsts.data(), counts.data(),
                    static_cast<GLsizei>(firsts.size()));
}

void MeshGeometry::draw(std::size_t part) const {
  const std::size_t start = starts_[part], count = starts_[part + 1] - start;
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                 reinterpret_cast<const void*>(start * sizeof(std::uint32_t)));
}

int frontFaceWinding(const body::Cage& cage) {
  constexpr double kClearlyOriented = 0.2;
  const Eigen::Array<double, 8, 1> determinants = cornerDeterminants(cage);
  // Clip y points down, which reverses every triangle's winding.
  if (determinants.minCoeff() > kClearlyOriented) return -1;
  return determinants.maxCoeff() < -kClearlyOriented ? 1 : 0;
}

}  // namespace rotatebook::render
