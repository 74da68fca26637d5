#include "scene/grid_settings.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace rotatebook::scene {
namespace {

/// Units of the numbers of keys, and of those within them.
constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kUnits{
    {{"body.size", "m"},
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

std::string nameOf(const GridAxis& axis) {
  if (!axis.label.empty()) return axis.label;
  const bool areNumbers = std::ranges::all_of(
      axis.values, [](const SweepValue& value) { return value.number.has_value(); });
  const std::string_view unit = areNumbers ? unitOf(axis.key) : "";
  return axis.key + (unit.empty() ? "" : "  [" + std::string(unit) + "]");
}

}  // namespace rotatebook::scene
