#include "render/body/body_painter.h"

namespace rotatebook::render {

void prepareToDraw(const DrawnBody& drawn) {
  glEnable(GL_DEPTH_TEST);
  drawn.winding == 0 ? glDisable(GL_CULL_FACE) : glEnable(GL_CULL_FACE);
  glFrontFace(drawn.winding < 0 ? GL_CW : GL_CCW);
}

void useFor(const ShaderProgram& program, const DrawnBody& drawn) {
  program.use();
  program.set("cage", Eigen::Matrix<float, 3, 8>(drawn.cage.cast<float>()));
  program.set("clipFromWorld", Eigen::Matrix4f(drawn.clipFromWorld.cast<float>()));
}

}  // namespace rotatebook::render
