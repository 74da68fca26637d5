// The interface for drawing one body with OpenGL. Inside the room only.
#pragma once

#include <Eigen/Core>

#include "body/cuboid.h"
#include "geometry/mesh.h"
#include "render/drawn_body.h"
#include "render/gl/shader_program.h"

namespace rotatebook::render {

/// Draws a body, projected as a DrawnBody says, into the frame buffer that is bound. `eye`: the
/// camera's position, world. [m]
class BodyPainter {
 public:
  BodyPainter() = default;
  BodyPainter(const BodyPainter&) = delete;
  BodyPainter& operator=(const BodyPainter&) = delete;
  virtual ~BodyPainter() = default;

  virtual const geometry::Mesh& mesh() const = 0;
  /// Draws the body's triangles. Sets the state that it relies on.
  virtual void draw(const DrawnBody& drawn, const Eigen::Vector3d& eye) const = 0;
  /// Draws its narrow strips as rows of a picture of all strips. Relies on the state of draw().
  virtual void drawStrips(const DrawnBody& drawn, const Eigen::Vector3d& eye) const = 0;
  /// Draws a body that fills its cage, with a pattern of which no two neighbours are alike, by the
  /// shaders of draw().
  virtual void drawTest(const DrawnBody& drawn, const Eigen::Vector3d& eye) const = 0;
};

/// Sets the state in which bodies are drawn.
void prepareToDraw(const DrawnBody& drawn);
/// Uses a program that begins with body.vert.
void useFor(const ShaderProgram& program, const DrawnBody& drawn);

}  // namespace rotatebook::render
