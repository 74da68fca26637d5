#include "scene/places.h"

namespace rotatebook::scene {

std::string labelKey(std::size_t panel) {
  return "panel." + std::to_string(panel) + ".label";
}

std::string placeOf(const Scene& scene, std::string_view key) {
  const auto place = scene.places.find(key);
  return place == scene.places.end() ? scene.name : place->second;
}

}  // namespace rotatebook::scene
