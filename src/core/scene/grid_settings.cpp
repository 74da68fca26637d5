#include "scene/grid_settings.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace rotatebook::scene {
namespace {

/// Units of the numbers of keys, and of those within them.
constexpr std::array<std::pair<std::string_view, std::string_view>, 10> kUnits{
    {{"time", "s"},
     {"spin", "degrees"},
     {"body.size", "m"},
     {"body.mass", "kg"},
     {"body.inertia", "kg m²"},
     {"simulation.stiffness", "N/m"},
     {"initial.tilt", "rad"},
     {"initial.angular_velocity", "rad/s"},
     {"initial.angular_momentum", "kg m²/s"},
     {"nudge.N.at", "s"}}};

std::string_view unitOf(std::string_view key) {
  constexpr std::string_view kNudge = "nudge.", kAt = ".at";
  if (key.starts_with(kNudge)) return key.ends_with(kAt) ? kUnits.back().second : "";
  for (const auto& [name, unit] : kUnits) {
    if (key == name || (key.starts_with(name) && key[name.size()] == '.')) return unit;
  }
  return "";
}

}  // namespace

std::string keyWithUnit(const std::string& key) {
  const std::string_view unit = unitOf(key);
  return key + (unit.empty() ? "" : "  [" + std::string(unit) + "]");
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
