// The interface for drawing bodies of one look with OpenGL. Inside the room only.
#pragma once

#include <span>

#include <Eigen/Core>

#include "geometry/hull_bands.h"
#include "geometry/mesh.h"
#include "render/drawn_body.h"
#include "render/gl/shader_program.h"

namespace rotatebook::render {

/// A body, projected as a DrawnBody says, and its place in the frame buffer that is bound.
struct PlacedBody {
  const DrawnBody* drawn = nullptr;
  Eigen::Vector3d eye;  ///< The camera's position, world. [m]
  /// The place of its picture, outside which nothing is drawn. [pixels]
  geometry::PixelRect picture;
};

/// Draws bodies, several part by part: OpenGL takes long to change a texture or a program.
class BodyPainter {
 public:
  BodyPainter() = default;
  BodyPainter(const BodyPainter&) = delete;
  BodyPainter& operator=(const BodyPainter&) = delete;
  virtual ~BodyPainter() = default;

  virtual const geometry::Mesh& mesh() const = 0;
  /// Draws the bodies' triangles.
  virtual void draw(std::span<const PlacedBody> bodies) const = 0;
  /// Draws their narrow strips, each body's as rows of a picture of all strips.
  virtual void drawStrips(std::span<const PlacedBody> bodies) const = 0;
  /// Draws a body that fills its cage, with a pattern of which no two neighbours are alike, by the
  /// shaders of draw().
  virtual void drawTest(const PlacedBody& body) const = 0;
};

/// Sets all the state in which a body is drawn, with `program`, which begins with body.vert and is
/// in use.
void prepareToDraw(const PlacedBody& body, const ShaderProgram& program);

}  // namespace rotatebook::render
