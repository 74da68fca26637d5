#include "scene/grid_settings.h"

#include <algorithm>

#include "scene/key_rows.h"

namespace rotatebook::scene {

std::string keyWithUnit(const std::string& key) {
  const KeyRow* row = findKey(key);
  // Maps alone have axes that are no keys.
  const std::string unit = row != nullptr             ? row->unit
                           : key == "time"            ? "s"
                           : key.starts_with("spin.") ? "degrees"
                                                      : "";
  return key + (unit.empty() ? "" : "  [" + unit + "]");
}

std::string nameOf(const SweepKey& axis) {
  const bool areNumbers = std::ranges::all_of(
      axis.values, [](const SweepValue& value) { return value.number.has_value(); });
  return areNumbers ? keyWithUnit(axis.key) : axis.key;
}

std::string nameOf(const GridAxis& axis) {
  return axis.label.empty() ? nameOf(static_cast<const SweepKey&>(axis)) : axis.label;
}

}  // namespace rotatebook::scene
