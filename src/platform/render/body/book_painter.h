// Draws the book with OpenGL. Inside the room only.
#pragma once

#include "geometry/book_mesh.h"
#include "render/body/body_painter.h"
#include "render/body/mesh_geometry.h"
#include "render/book_textures.h"
#include "render/gl/texture.h"

namespace rotatebook::render {

/// The book: a cover of cloth with gold, and paper.
class BookPainter final : public BodyPainter {
 public:
  BookPainter(const BookTextures& textures, geometry::MeshDetail detail);

  const geometry::Mesh& mesh() const override { return mesh_; }
  void draw(const DrawnBody& drawn, const Eigen::Vector3d& eye) const override;
  void drawStrips(const DrawnBody& drawn, const Eigen::Vector3d& eye) const override;
  void drawTest(const DrawnBody& drawn, const Eigen::Vector3d& eye) const override;

 private:
  /// The textures of the parts of a book.
  struct Surfaces {
    const Texture& front;
    const Texture& spine;
    const Texture& back;
    const Texture& paper;
  };

  void drawParts(const DrawnBody& drawn, const Eigen::Vector3d& eye,
                 const Surfaces& surfaces) const;
  void drawPart(geometry::BookPart part, const Texture& texture) const;
  void drawCover(geometry::BookPart part, const Texture& texture) const;
  void drawStripsOf(geometry::BookPart part, const Texture& texture, const DrawnBody& drawn) const;
  void drawCoverStrips(geometry::BookPart part, const Texture& texture,
                       const DrawnBody& drawn) const;

  geometry::Mesh mesh_;
  ShaderProgram coverProgram_, paperProgram_;
  MeshGeometry geometry_;
  Texture front_, spine_, back_, paper_;
};

}  // namespace rotatebook::render
