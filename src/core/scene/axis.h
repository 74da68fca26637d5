// An axis of variation: a key of a motion and its values, which [grid] draws as books, [study] as
// curves and [map] as pixels.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/document/toml_tree.h"
#include "scene/scale.h"

namespace rotatebook::scene {

/// A value of an axis.
struct AxisValue {
  std::string toml;                ///< As a scene states it, with its label if that is stated.
  std::string label;               ///< The number or the word, or what is stated.
  std::optional<double> number{};  ///< The value, if it is a number without a label.
  document::TomlNode node{};       ///< The value, which takes the place of the key's own.

  /// Compares all but the node, whose value `toml` has.
  friend bool operator==(const AxisValue& a, const AxisValue& b) {
    return a.toml == b.toml && a.label == b.label && a.number == b.number;
  }
};

/// The special keys of a map's axis; all others are keys of a motion.
enum class AxisKind {
  MotionKey,
  Time,            ///< "time": one motion serves a whole line of pixels. [s]
  SpinLongitude,   ///< "spin.longitude": direction of the first spin, from x toward y. [degrees]
  SpinLatitude,    ///< "spin.latitude": likewise, from the plane of x and y toward z. [degrees]
  SmallestMoment,  ///< "moments.smallest": smallest / largest moment of inertia.
  MiddleMoment,    ///< "moments.middle": middle / largest moment of inertia.
};

/// A key, "section.key", and its values: a list, or a range of a map, of which each pixel has the
/// value in its middle.
struct Axis {
  std::string key;
  std::vector<AxisValue> values{};  ///< Each with another label; none on a map.
  std::string label{};              ///< Beside the axis; empty for the key and its unit.
  /// Names of keys that the scene leaves out, so that their defaults follow the axis.
  std::vector<std::string_view> followers{};
  AxisKind kind = AxisKind::MotionKey;
  double from = 0;  ///< At a map's left, or at its bottom.
  double to = 1;    ///< > from
  Scale scale = Scale::Linear;

  /// Returns whether all values are numbers without labels.
  bool hasNumbers() const {
    return std::ranges::all_of(values, [](const AxisValue& value) { return !!value.number; });
  }
  /// Returns the value in the middle of pixel `i` of `count`.
  double at(int i, int count) const {
    return numberWithin(from, to, (static_cast<double>(i) + 0.5) / count, scale);
  }
  bool holds(double value) const { return value >= from && value <= to; }
  friend bool operator==(const Axis&, const Axis&) = default;
};

}  // namespace rotatebook::scene
