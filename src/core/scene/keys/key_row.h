// A row of the documentation of scene files. Inside the room only.
#pragma once

#include <string>

namespace rotatebook::scene {

/// The documentation of one key, in Markdown.
struct KeyRow {
  std::string name;       ///< With its section: "clip.size".
  std::string byDefault;  ///< The value as TOML, or a description of one that depends on others.
  std::string allowed;    ///< The allowed values, as in messages: "a number".
  std::string meaning;
};

}  // namespace rotatebook::scene
