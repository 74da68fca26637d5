// Draws the book with OpenGL. Inside the room only.
#pragma once

#include <span>

#include "geometry/book_mesh.h"
#include "render/body/body_painter.h"
#include "render/body/mesh_geometry.h"
#include "render/book_textures.h"
#include "render/gl/texture.h"

namespace rotatebook::render {

/// The share of light that leaves scatter onto the cover beside them, which hides half the
/// surroundings from them.
inline const Eigen::Vector3f kScatteredByLeaves(0.52F, 0.45F, 0.33F);
/// Returns the share that a cover scatters onto the leaves: that of its foot, in the middle.
Eigen::Vector3f scatteredByCover(const image::Image& front);
/// Returns a side of the cover as the shader takes it, withGold().
Texture coverTexture(const image::Image& side);

/// The book: a cover of cloth with gold, and paper.
class BookPainter final : public BodyPainter {
 public:
  BookPainter(const BookTextures& textures, geometry::MeshDetail detail);

  const geometry::Mesh& mesh() const override { return mesh_; }
  void draw(std::span<const PlacedBody> bodies) const override;
  void drawStrips(std::span<const PlacedBody> bodies) const override;
  void drawTest(const PlacedBody& body) const override;

 private:
  /// The textures of the parts of a book.
  struct Surfaces {
    const Texture& front;
    const Texture& spine;
    const Texture& back;
    const Texture& paper;
    Eigen::Vector3f scatteredByCover;
  };

  void drawParts(std::span<const PlacedBody> bodies, const Surfaces& surfaces) const;
  /// Calls draw(part, program) for each part once its program and texture are in use.
  template <typename Draw>
  void eachPart(const Surfaces& surfaces, const Draw& draw) const;

  geometry::Mesh mesh_;
  ShaderProgram coverProgram_, paperProgram_;
  MeshGeometry geometry_;
  Eigen::Vector3f scatteredByCover_;
  Texture front_, spine_, back_, paper_;
};

}  // namespace rotatebook::render
