// Finds the edges in a body's picture, and the triangles beside them. Inside the room only.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "body/cuboid.h"
#include "geometry/mesh.h"
#include "render/antialias/edge_pixels.h"
#include "render/antialias/edge_samples.h"
#include "render/antialias/strips.h"

namespace rotatebook::render {

/// A mesh's triangles, and those of their sides that can be edges in a picture.
class BodyEdges {
 public:
  explicit BodyEdges(const geometry::Mesh& mesh);

  /// Projects the body in this cage onto a picture of the size of `pixels`. Adds to `pixels` those
  /// through which the outline of a surface or the border of two surfaces passes, hidden ones
  /// included, and to `triangles` all that are drawn. Both are clipped at the near plane.
  /// `winding`: from frontFaceWinding(). `strips`: by strip number; a narrow one is a surface of
  /// its own.
  void find(const body::Cage& cage, const Eigen::Matrix4d& clipFromWorld, int winding,
            std::span<const ScreenStrip> strips, EdgePixels& pixels,
            std::vector<ScreenTriangle>& triangles) const;

 private:
  struct Triangle {
    std::array<std::uint32_t, 3> vertices;
    float surfaceId;
    bool hidden;  // Drawn only where all triangles are.
    std::uint8_t strip;
  };
  /// A side of one triangle, or of two that share it.
  struct Edge {
    std::array<std::uint32_t, 2> ends;    // Vertex indices.
    std::uint32_t first;                  // Triangle index.
    std::optional<std::uint32_t> second;  // Triangle index.
    bool smooth;  // Both triangles have the same vertices there, and the same strip.
  };

  /// Adds the visible part of a triangle; returns its winding in the picture, 1 from x to y or -1,
  /// or 0 if it isn't drawn.
  static int addTriangle(const Triangle& triangle, const std::vector<Eigen::Vector4d>& points,
                         int winding, std::span<const ScreenStrip> strips, const EdgePixels& pixels,
                         std::vector<ScreenTriangle>& triangles);
  /// Returns the triangle's ScreenTriangle::surfaceId.
  static float surfaceIdOf(const Triangle& triangle, std::span<const ScreenStrip> strips);

  std::vector<Triangle> triangles_;
  std::vector<Edge> edges_;
  std::vector<Eigen::Matrix<double, 8, 1>> cageWeights_;  // By vertex.
};

}  // namespace rotatebook::render
