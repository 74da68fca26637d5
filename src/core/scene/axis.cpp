#include "scene/axis.h"

#include <algorithm>

#include "scene/key_rows.h"

namespace rotatebook::scene {

bool Axis::hasNumbers() const {
  return std::ranges::all_of(values,
                             [](const AxisValue& value) { return value.number.has_value(); });
}

std::string keyWithUnit(const std::string& key) {
  const KeyRow* row = findKey(key);
  // Maps alone have axes that are no keys.
  const std::string unit = row != nullptr             ? row->unit
                           : key == "time"            ? "s"
                           : key.starts_with("spin.") ? "degrees"
                                                      : "";
  return key + (unit.empty() ? "" : "  [" + unit + "]");
}

std::string nameOf(const Axis& axis) {
  if (!axis.label.empty()) return axis.label;
  return axis.hasNumbers() ? keyWithUnit(axis.key) : axis.key;
}

}  // namespace rotatebook::scene
