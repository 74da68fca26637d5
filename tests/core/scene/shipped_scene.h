// The scenes that ship, for tests of rooms that open no files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "scene/scene_text.h"

namespace rotatebook::scene {

/// Reads scenes/NAME.toml; `overrides` as --set takes them.
inline Scene shippedScene(const std::string& name, const std::vector<std::string>& overrides = {}) {
  const std::string path = std::string(ROTATEBOOK_SOURCE) + "/scenes/" + name + ".toml";
  const auto textOf = [](const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  return parseScene(textOf(path), path, overrides,
                    [&](const std::filesystem::path& file, std::size_t) {
                      return textOf(std::filesystem::path(path).parent_path() / file);
                    });
}

}  // namespace rotatebook::scene
