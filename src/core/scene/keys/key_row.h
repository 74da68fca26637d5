// A key of a scene file in words.
#pragma once

#include <string>

namespace rotatebook::scene {

/// A key in words, all of them Markdown.
struct KeyRow {
  std::string name;       ///< With its section: "clip.size".
  std::string byDefault;  ///< The value as TOML, or words for one that depends on others.
  std::string allowed;    ///< The values it may have, in the words of messages: "a text".
  std::string meaning;
};

}  // namespace rotatebook::scene
