// Options that are short for overrides. Inside the room only.
#pragma once

#include <string>

namespace rotatebook::cli {

/// An option that is short for an override of the scene.
struct Shorthand {
  std::string option;      ///< As the user wrote it: "--size 640x360"; messages name it so.
  std::string assignment;  ///< "clip.size=[640, 360]"
};

}  // namespace rotatebook::cli
