#include "scene/source_locations.h"

namespace rotatebook::scene {

std::string labelKey(std::size_t panel) {
  return "panel." + std::to_string(panel) + ".label";
}

std::string locationOf(const Scene& scene, std::string_view key) {
  const auto location = scene.locations.find(key);
  return location == scene.locations.end() ? scene.name : location->second;
}

}  // namespace rotatebook::scene
