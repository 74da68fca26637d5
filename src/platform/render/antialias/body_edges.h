// Where the book's picture has edges, and what is seen beside them. Inside the room only.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "physics/cuboid.h"
#include "render/antialias/edge_pixels.h"
#include "render/antialias/edge_samples.h"
#include "render/antialias/strips.h"
#include "render/book/book_mesh.h"

namespace rotatebook::render {

/// The mesh's triangles, and those of their sides that can be edges of a picture.
class BodyEdges {
 public:
  explicit BodyEdges(const BookMesh& mesh);

  /// Adds the pixels through which an outline of a surface goes or two surfaces meet, hidden ones
  /// among them, and the triangles that are drawn, of the body in this cage in a picture of
  /// the pixels' size; without what reaches behind the camera. `winding`: as windingOf()
  /// has it. `strips`, by their numbers: one that is narrow is a surface by itself.
  void find(const physics::Cage& cage, const Eigen::Matrix4d& clipFromWorld, int winding,
            std::span<const ScreenStrip> strips, EdgePixels& pixels,
            std::vector<ScreenTriangle>& triangles) const;

 private:
  struct Triangle {
    std::array<std::uint32_t, 3> vertices;
    float surface;
    bool lining;  // Drawn only where all triangles are.
    std::uint8_t strip;
  };
  /// A side of one triangle, or of two that share it.
  struct Edge {
    std::array<std::uint32_t, 2> ends;  // vertices
    std::uint32_t first;                // triangles
    std::optional<std::uint32_t> second;
  };

  /// Adds what is seen of a triangle; returns which way it turns, or 0 if it isn't drawn.
  static int addTriangle(const Triangle& triangle, const std::vector<Eigen::Vector4d>& points,
                         int winding, std::span<const ScreenStrip> strips, const EdgePixels& pixels,
                         std::vector<ScreenTriangle>& triangles);
  /// ScreenTriangle::surface
  static float surfaceOf(const Triangle& triangle, std::span<const ScreenStrip> strips);

  std::vector<Triangle> triangles_;
  std::vector<Edge> edges_;
  std::vector<Eigen::Matrix<double, 8, 1>> shares_;  // of the cage in each vertex's place
};

}  // namespace rotatebook::render
