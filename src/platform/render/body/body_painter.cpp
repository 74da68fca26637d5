#include "render/body/body_painter.h"

namespace rotatebook::render {

void prepareToDraw(const PlacedBody& body, const ShaderProgram& program) {
  const auto& [drawn, eye, picture] = body;
  glViewport(picture.x, picture.y, picture.width, picture.height);
  glEnable(GL_DEPTH_TEST);
  drawn->winding == 0 ? glDisable(GL_CULL_FACE) : glEnable(GL_CULL_FACE);
  glFrontFace(drawn->winding < 0 ? GL_CW : GL_CCW);
  program.set("cage", Eigen::Matrix<float, 3, 8>(drawn->cage.cast<float>()));
  program.set("clipFromWorld", Eigen::Matrix4f(drawn->clipFromWorld.cast<float>()));
  program.set("eye", Eigen::Vector3f(eye.cast<float>()));
}

}  // namespace rotatebook::render
