// The scenes that ship, for tests of rooms that open no files.
#pragma once

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "scene/scene_text.h"

namespace rotatebook::scene {

/// Reads scenes/NAME.toml; `overrides` as --set takes them.
inline Scene shippedScene(const std::string& name, const std::vector<std::string>& overrides = {}) {
  const std::string path = std::string(ROTATEBOOK_SOURCE) + "/scenes/" + name + ".toml";
  std::ifstream stream(path);
  return parseScene(std::string(std::istreambuf_iterator<char>(stream), {}), path, overrides);
}

}  // namespace rotatebook::scene
