#include "scene/grid_settings.h"

#include <algorithm>

#include "scene/key_rows.h"

namespace rotatebook::scene {

std::string keyWithUnit(const std::string& key) {
  const std::string_view unit = unitOf(key);
  return key + (unit.empty() ? "" : "  [" + std::string(unit) + "]");
}

std::string nameOf(const SweepKey& axis) {
  const bool areNumbers = std::ranges::all_of(
      axis.values, [](const SweepValue& value) { return value.number.has_value(); });
  return areNumbers ? axisName(axis.key) : axis.key;
}

}  // namespace rotatebook::scene
