// Facts about an OpenGL context. Inside the room only.
#pragma once

#include <string>

namespace rotatebook::render {

/// Facts that an OpenGL context reports about itself.
struct ContextInfo {
  std::string vendor, renderer;
  std::string version;  ///< OpenGL's, such as "4.5".
  int samples = 0;      ///< GL_MAX_SAMPLES
};

}  // namespace rotatebook::render
