#include "render/book_geometry.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/LU>

namespace rotatebook::render {
namespace {

/// Which vertex attribute is which, as book.vert numbers them.
void describeVertex() {
  const auto attribute = [](GLuint index, GLint size, std::size_t offset) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, sizeof(BookVertex),
                          reinterpret_cast<const void*>(offset));
  };
  attribute(0, 3, offsetof(BookVertex, place));
  attribute(1, 3, offsetof(BookVertex, normal));
  attribute(2, 2, offsetof(BookVertex, texture));
  attribute(3, 1, offsetof(BookVertex, openness));
  attribute(4, 1, offsetof(BookVertex, surface));
}

template <typename Element>
void upload(GLenum target, const GlBuffer& buffer, const std::vector<Element>& elements) {
  glBindBuffer(target, buffer.name());
  glBufferData(target, static_cast<GLsizeiptr>(elements.size() * sizeof(Element)), elements.data(),
               GL_STATIC_DRAW);
}

/// Signed volume at each corner of the map from the unit cube, as a share of the largest. Negative:
/// inside out.
Eigen::Array<double, 8, 1> cornerVolumes(const physics::Corners& corners) {
  Eigen::Array<double, 8, 1> volumes;
  for (int i = 0; i < 8; ++i) {
    Eigen::Matrix3d edges;
    for (int axis = 0; axis < 3; ++axis) {
      const int other = i ^ (1 << axis);
      const double sign = (i & (1 << axis)) != 0 ? 1 : -1;
      edges.col(axis) = sign * (corners.col(i) - corners.col(other));
    }
    volumes[i] = edges.determinant();
  }
  return volumes / std::max(volumes.abs().maxCoeff(), std::numeric_limits<double>::min());
}

}  // namespace

BookGeometry::BookGeometry(const BookMesh& mesh) {
  std::vector<std::uint32_t> indices;
  for (std::size_t part = 0; part < kBookPartCount; ++part) {
    starts_[part] = indices.size();
    indices.insert(indices.end(), mesh.triangles[part].begin(), mesh.triangles[part].end());
  }
  starts_[kBookPartCount] = indices.size();
  glBindVertexArray(array_.name());
  upload(GL_ARRAY_BUFFER, vertices_, mesh.vertices);
  upload(GL_ELEMENT_ARRAY_BUFFER, indices_, indices);
  describeVertex();
}

void BookGeometry::draw(BookPart part) const {
  const auto index = static_cast<std::size_t>(part);
  const std::size_t start = starts_[index], count = starts_[index + 1] - start;
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                 reinterpret_cast<const void*>(start * sizeof(std::uint32_t)));
}

int drawnFacing(const physics::Corners& corners) {
  constexpr double kClearlyOneWay = 0.2;
  const Eigen::Array<double, 8, 1> volumes = cornerVolumes(corners);
  // Clip y points down, which turns every triangle round.
  if (volumes.minCoeff() > kClearlyOneWay) return -1;
  return volumes.maxCoeff() < -kClearlyOneWay ? 1 : 0;
}

}  // namespace rotatebook::render
