// What an OpenGL context is of. Inside the room only.
#pragma once

#include <string>

namespace rotatebook::render {

/// What an OpenGL context reports of itself.
struct ContextInfo {
  std::string vendor, renderer;
  std::string version;  ///< Of OpenGL: "4.5"
  int samples = 0;      ///< GL_MAX_SAMPLES
};

}  // namespace rotatebook::render
