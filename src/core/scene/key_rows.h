// Every key of a scene file in words, as docs/scene.md has them.
#pragma once

#include <string>
#include <vector>

namespace rotatebook::scene {

/// A key in words, all of them Markdown.
struct KeyRow {
  std::string name;       ///< With its section: "clip.size".
  std::string byDefault;  ///< The value as TOML, or words for one that depends on others.
  std::string allowed;    ///< The values it may have, in the words of messages: "a text".
  std::string meaning;
};

/// All keys, section by section, each section's in the order of messages.
std::vector<KeyRow> allKeys();

}  // namespace rotatebook::scene
