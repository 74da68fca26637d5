// Draws a body of any shape with OpenGL. Inside the room only.
#pragma once

#include <memory>
#include <vector>

#include "render/body/body_painter.h"
#include "render/body/mesh_geometry.h"
#include "render/gl/texture.h"
#include "render/surface_look.h"

namespace rotatebook::render {

/// A surface with materials of the metallic-roughness model.
class SurfacePainter final : public BodyPainter {
 public:
  explicit SurfacePainter(const SurfaceLook& look);

  const geometry::Mesh& mesh() const override { return mesh_; }
  void draw(std::span<const PlacedBody> bodies) const override;
  /// They have none.
  void drawStrips(std::span<const PlacedBody>) const override {}
  void drawTest(const PlacedBody& body) const override;

 private:
  void begin() const;
  void useMaterial(const body::Material& material) const;

  geometry::Mesh mesh_;
  Eigen::Vector3d size_;
  std::vector<body::Material> materials_;
  ShaderProgram program_;
  MeshGeometry geometry_, testGeometry_;
  Texture white_;
  // By image of the look; null where no material uses it so.
  std::vector<std::unique_ptr<Texture>> colours_, numbers_;
};

}  // namespace rotatebook::render
