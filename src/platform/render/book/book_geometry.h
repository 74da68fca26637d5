// The book's mesh on the graphics side. Inside the room only.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "physics/cuboid.h"
#include "render/antialias/strips.h"
#include "render/book/book_mesh.h"
#include "render/book/gl_handles.h"

namespace rotatebook::render {

/// The vertices and triangles of the mesh, uploaded.
class BookGeometry {
 public:
  explicit BookGeometry(const BookMesh& mesh);

  /// Makes its vertices those that draw() draws.
  void bind() const { glBindVertexArray(array_.name()); }
  /// Draws one part with the program in use.
  void draw(BookPart part) const;

  /// Makes the strips' vertices those that drawStrips() draws.
  void bindStrips() const { glBindVertexArray(stripArray_.name()); }
  /// Draws the middles of a part's narrow strips as rows of a picture of all strips.
  void drawStrips(BookPart part, const std::vector<ScreenStrip>& seen) const;

 private:
  /// A strip among the strips' vertices.
  struct Row {
    BookPart part;
    GLint first;
    GLsizei count;
  };

  void uploadStrips(const std::vector<BookStrip>& strips);

  GlVertexArray array_, stripArray_;
  GlBuffer vertices_, indices_, stripVertices_;
  std::vector<Row> rows_;
  std::array<std::size_t, kBookPartCount + 1> starts_{};  // of each part among the indices
};

/// Which way triangles turn in the picture, from x to y (1) or from y to x (-1), that are to be
/// drawn, as those that look away from the eye aren't; 0 if all are, because the book is so
/// deformed that any may be seen.
int windingOf(const physics::Cage& cage);

}  // namespace rotatebook::render
