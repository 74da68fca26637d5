// Uploads a body's mesh to OpenGL and draws it. Inside the room only.
#pragma once

#include <cstddef>
#include <vector>

#include "body/cuboid.h"
#include "geometry/mesh.h"
#include "render/antialias/strips.h"
#include "render/gl/gl_handles.h"

namespace rotatebook::render {

/// A mesh's vertices and triangles in OpenGL buffers.
class MeshGeometry {
 public:
  explicit MeshGeometry(const geometry::Mesh& mesh);

  /// Binds the vertices for draw().
  void bind() const { glBindVertexArray(array_.name()); }
  /// Draws one part, by its index, with the program in use.
  void draw(std::size_t part) const;

  /// Returns whether a part has narrow strips. `onScreen`: by strip number.
  bool hasNarrowStrips(std::size_t part, const std::vector<ScreenStrip>& onScreen) const;
  /// Binds the strips' vertices for drawStrips().
  void bindStrips() const { glBindVertexArray(stripArray_.name()); }
  /// Draws the middle lines of a part's narrow strips as rows of a picture of all strips, with the
  /// program in use.
  void drawStrips(std::size_t part, const std::vector<ScreenStrip>& onScreen) const;

 private:
  /// A strip's range of the strips' vertices.
  struct Row {
    std::size_t part;
    GLint first;
    GLsizei count;
  };

  void uploadStrips(const std::vector<geometry::MeshStrip>& strips);

  GlVertexArray array_, stripArray_;
  GlBuffer vertices_, indices_, stripVertices_;
  std::vector<Row> rows_;
  std::vector<std::size_t> starts_;  // First index of each part, and the end.
};

/// Returns the winding that front faces have in the picture, 1 from x to y or -1 from y to x; only
/// they are to be drawn. Returns 0 if the cage is so deformed that any triangle may be visible: all
/// are to be drawn.
int frontFaceWinding(const body::Cage& cage);

}  // namespace rotatebook::render
