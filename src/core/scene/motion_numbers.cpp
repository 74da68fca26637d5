#include "scene/motion_numbers.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/document/toml_tree.h"
#include "base/error.h"
#include "base/nearest_name.h"
#include "base/parsed_number.h"
#include "scene/key_rows.h"
#include "scene/keys/keys.h"

namespace rotatebook::scene {
namespace {

using document::TomlNode;
using physics::MotionSettings;

/// Reads a value of a key of [body], [simulation], [initial] or [[nudge]] into a motion. Throws
/// InputError.
using ReadMotionKey = std::function<void(MotionSettings&, const TomlNode&)>;

/// A key in its parts: "initial", "tilt" and "0" of "initial.tilt.0".
struct Path {
  std::string section, name, within;
};

/// The parts of a message about a key.
struct Place {
  const std::string& key;
  const std::string& location;
};

Path pathOf(const std::string& key) {
  const std::size_t first = std::min(key.find('.'), key.size());
  const std::size_t second = std::min(key.find('.', first + 1), key.size());
  const auto part = [&key](std::size_t begin, std::size_t end) {
    return begin < end ? key.substr(begin, end - begin) : "";
  };
  return {part(0, first), part(first + 1, second), part(second + 1, key.size())};
}

TomlNode numberNode(double value, bool isWhole, const std::string& location) {
  constexpr double kLargest = 9e15;  // whole numbers up to here are exact
  if (!isWhole) return {value, location};
  return {static_cast<std::int64_t>(std::clamp(std::round(value), -kLargest, kLargest)), location};
}

template <typename S>
const Key<S>& keyNamed(Keys<S> keys, const Path& path, const Place& place) {
  const auto found = std::ranges::find(keys, path.name, &Key<S>::name);
  if (found != keys.end()) return *found;
  std::vector<std::string_view> names;
  for (const Key<S>& key : keys) names.push_back(key.name);
  document::failAt(place.location, "there is no key " + place.key + didYouMean(path.name, names));
}

/// Throws InputError unless the value that `base` has of the key has parts.
template <typename S>
void requireParts(const Key<S>& key, const S& base, const Path& path, const Place& place) {
  const std::string whole = path.section + "." + path.name;
  if (!key.hasParts())
    document::failAt(place.location, whole + " has no parts, and so no " + place.key);
  if (!key.text(base).empty()) return;
  document::failAt(place.location, place.key + " is a part of " + whole +
                                       ", which the scene doesn't state; state it");
}

/// Returns what reads a value into the key of an S, which `part` finds in a motion.
template <typename S, typename Part>
ReadMotionKey readerIn(Keys<S> keys, Part part, const MotionSettings& base, const Path& path,
                       const Place& place) {
  const Key<S>& key = keyNamed(keys, path, place);
  MotionSettings copy = base;
  if (!path.within.empty()) requireParts(key, part(copy), path, place);
  return [=, &key, name = path.section + "." + path.name](MotionSettings& motion,
                                                          const TomlNode& node) {
    const ValueReader value(node, name);
    if (path.within.empty()) return key.read(value, part(motion));
    key.readPart(value, path.within, part(motion));
  };
}

/// Returns the number of the nudge that "nudge.0.at" is of.
std::size_t nudgeOf(const Path& path, const MotionSettings& base, const Place& place) {
  const auto index = parsedNumber<std::size_t>(path.name);
  if (index && *index < base.nudges.size()) return *index;
  if (base.nudges.empty()) document::failAt(place.location, place.key + kOfNoNudge);
  document::failAt(place.location, place.key + " must name one of the scene's " +
                                       countText(base.nudges.size(), "nudge") +
                                       " by its number, from 0");
}

/// Returns what reads values of `motionKey`, such as "body.mass", or of a part, such as
/// "initial.tilt.0", which `base` states. Throws InputError at `location` if there is none.
ReadMotionKey readerOf(const MotionSettings& base, const std::string& motionKey,
                       const std::string& location) {
  const Place place{motionKey, location};
  const Path path = pathOf(place.key);
  if (path.section == "body") {
    return readerIn(
        bodyKeys(), [](MotionSettings& motion) -> MotionSettings& { return motion; }, base, path,
        place);
  }
  if (path.section == "simulation") {
    return readerIn(
        simulationKeys(), [](MotionSettings & motion) -> auto& { return motion.simulation; }, base,
        path, place);
  }
  if (path.section == "initial") {
    return readerIn(
        initialKeys(), [](MotionSettings & motion) -> auto& { return motion.initial; }, base, path,
        place);
  }
  if (path.section == "nudge") {
    const std::size_t index = nudgeOf(path, base, place);
    Path within = pathOf("nudge." + path.within);
    return readerIn(
        nudgeKeys(), [index](MotionSettings & motion) -> auto& { return motion.nudges[index]; },
        base, within, place);
  }
  constexpr std::array<std::string_view, 4> kSections{"body", "simulation", "initial", "nudge"};
  document::failAt(place.location, place.key + " is no key of " + quotedList(kSections, "or") +
                                       ", such as \"simulation.substeps\"" +
                                       didYouMean(path.section, kSections));
}

}  // namespace

MotionNumber::MotionNumber(const MotionSettings& base, const std::string& key, double example,
                           const std::string& location) {
  const KeyRow* row = findKey(key);
  isWhole_ = row != nullptr && row->form.isWhole();
  // As grids and studies take it: the angle, whose axis stays
  const std::string path = key == "initial.tilt" ? key + ".0" : key;
  set_ = [read = readerOf(base, path, location), location, isWhole = isWhole_](
             MotionSettings& motion, double number) {
    read(motion, numberNode(number, isWhole, location));
  };
  MotionSettings motion = base;
  set_(motion, example);
}

}  // namespace rotatebook::scene
