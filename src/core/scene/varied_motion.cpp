#include "scene/varied_motion.h"

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "base/document/overrides.h"
#include "base/document/problems.h"
#include "base/document/toml_text.h"
#include "base/nearest_name.h"
#include "scene/key_rows.h"
#include "scene/motion_numbers.h"
#include "scene/names.h"
#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

using document::TomlEntry;
using document::TomlNode;

/// A key whose default depends on the value of another.
struct DependentKey {
  std::string_view section, name, of;
};
constexpr DependentKey kDependentKeys[] = {{"simulation", "integrator", "simulation.model"},
                                           {"body", "size", "body.shape"},
                                           {"body", "mass", "body.shape"},
                                           {"body", "dimensions", "body.shape"},
                                           {"body", "size", "body.part"},
                                           {"body", "mass", "body.part"}};

/// Returns the sections that settle a motion, which are those but [expect].
std::span<const Section<Motion>> physicsSections() {
  return motionSections().first(motionSections().size() - 1);
}

void requireMotionKey(const ValueReader& key, const std::string& text) {
  std::vector<std::string_view> names;
  for (const auto& section : physicsSections()) names.push_back(section.name);
  const std::string first = text.substr(0, text.find('.'));
  const bool isSection = std::ranges::count(names, first) > 0;
  const KeyRow* row = findKey(text);
  if (row != nullptr ? row->mayVary : isSection && first != text) return;
  key.fail(key.name() + " must be a key of " + quotedList(names, "or") +
           ", such as \"simulation.substeps\", not " + describe(key.node()) +
           (isSection ? "" : didYouMean(first, names)));
}

constexpr std::string_view kInitial = "initial.", kTilt = "initial.tilt";

bool isAngle(const AxisValue& value) {
  return !std::holds_alternative<TomlNode::Array>(value.node.value);
}

/// Throws InputError if an axis is of a part of a start that `sections` don't state.
void requireWhole(const TomlNode& sections, const PlacedAxis& placed, const std::string& key) {
  if (!key.starts_with(kInitial)) return;
  const std::string whole = key.substr(0, key.find('.', kInitial.size()));
  if (whole == key || findKey(whole) == nullptr) return;
  if (ValueReader(sections, "").find("initial", whole.substr(kInitial.size()))) return;
  document::failAt(placed.location,
                   whole == kTilt
                       ? "the scene has no initial.tilt, whose angle would vary; state it, such as "
                         "initial.tilt = [0.01, \"z\"]"
                       : placed.axis->key + " is a part of " + whole +
                             ", which the scene doesn't state; state it");
}

/// Returns the sections that settle a motion, as far as `file` has them.
TomlNode motionPart(const ValueReader& file) {
  TomlNode::Table sections;
  for (const auto& section : physicsSections()) {
    const auto* table = std::get_if<TomlNode::Table>(&file.node().value);
    if (const auto* entry = find(*table, section.name)) sections.push_back(*entry);
  }
  return {std::move(sections), file.node().location};
}

/// Puts a value of an axis, if there is one, into sections of a motion.
void put(TomlNode& sections, const PlacedAxis& placed, std::size_t index) {
  if (placed.axis == nullptr) return;
  const std::string key = variedKey(*placed.axis);
  const TomlNode& value = placed.axis->values[index].node;
  requireWhole(sections, placed, key);
  putValue(sections, key, value, placed.location, kMotionAlternatives);
  if (!key.starts_with(kInitial)) return;
  // Find what is wrong with a start where it is varied
  TomlEntry& start = *find(std::get<TomlNode::Table>(sections.value), "initial");
  for (TomlEntry& entry : std::get<TomlNode::Table>(start.node.value))
    entry.node.location = value.location;
}

Motion motionFrom(const TomlNode& sections) {
  const ValueReader file(sections, "");
  Motion motion;
  std::vector<document::Field> fields;
  addFields(fields, physicsSections(), motion);
  file.readTable(fields);
  checkMotion(file, motion.simulation);
  motion.locations = document::locationsOf(sections);
  return motion;
}

}  // namespace

std::string variedKey(const Axis& axis) {
  const bool isOfAngles = axis.key == kTilt && std::ranges::all_of(axis.values, isAngle);
  return isOfAngles ? axis.key + ".0" : axis.key;
}

void finishAxis(const ValueReader& table, const ValueReader& file, Axis& axis) {
  const ValueReader key = *table.find("key");
  requireMotionKey(key, axis.key);
  if (axis.key == "body.mesh")
    key.fail(axis.key + " can't vary; [[panel]] shows several meshes side by side");
  if (axis.key.starts_with("nudge.") && !file.find("nudge")) key.fail(axis.key + kOfNoNudge);
  for (const auto& [section, name, of] : kDependentKeys) {
    if (of == axis.key && !file.find(section, name)) axis.followers.push_back(name);
  }
}

std::vector<physics::Model> modelsOf(const std::vector<Panel>& motions) {
  std::vector<physics::Model> models;
  for (const Panel& panel : motions) models.push_back(panel.simulation.model);
  return models;
}

void refuseUnused(const std::string& location, const std::string& key,
                  const std::vector<physics::Model>& models, const std::string& motions) {
  const std::string reason = reasonForNoChange(key, models);
  if (!reason.empty())
    document::failAt(location, reason + "; all " + motions + " would be the same");
}

void readVaried(const ValueReader& file, const PlacedAxis& outer, const PlacedAxis& inner,
                const TakeMotion& take) {
  const TomlNode common = motionPart(file);
  document::Problems problems;
  for (std::size_t i = 0; i < outer.count(); ++i) {
    TomlNode sections = common;
    problems.note([&] {
      put(sections, outer, i);
      for (std::size_t j = 0; j < inner.count(); ++j) {
        problems.note([&] {
          TomlNode varied = sections;
          put(varied, inner, j);
          take(i, j, motionFrom(varied));
        });
      }
    });
  }
  problems.throwIfAny();
}

}  // namespace rotatebook::scene
