#include "base/document/locations.h"

#include <cstddef>
#include <variant>

namespace rotatebook::document {
namespace {

void addLocations(const TomlNode& node, const std::string& key, Locations& locations) {
  locations.byKey.emplace(key, node.location);
  const std::string prefix = key.empty() ? "" : key + ".";
  if (const auto* table = std::get_if<TomlNode::Table>(&node.value)) {
    for (const TomlEntry& entry : *table) addLocations(entry.node, prefix + entry.key, locations);
  } else if (const auto* array = std::get_if<TomlNode::Array>(&node.value)) {
    for (std::size_t i = 0; i < array->size(); ++i)
      addLocations((*array)[i], prefix + std::to_string(i), locations);
  }
}

}  // namespace

std::string Locations::of(const std::vector<std::string>& keys) const {
  for (const std::string& key : keys) {
    const auto location = byKey.find(key);
    if (location != byKey.end()) return location->second;
  }
  const auto whole = byKey.find("");
  return whole == byKey.end() ? "" : whole->second;
}

Locations locationsOf(const TomlNode& root) {
  Locations locations;
  addLocations(root, "", locations);
  return locations;
}

}  // namespace rotatebook::document
