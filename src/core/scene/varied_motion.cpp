#include "scene/varied_motion.h"

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "base/document/overrides.h"
#include "base/document/toml_text.h"
#include "base/nearest_name.h"
#include "scene/key_rows.h"
#include "scene/names.h"
#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

using document::TomlNode;

/// Returns the sections that settle a motion, which are those but [expect].
std::span<const Section<Motion>> physicsSections() {
  return motionSections().first(motionSections().size() - 1);
}

void requireMotionKey(const ValueReader& key) {
  const std::string text = key.text(kLongestPath);
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

bool isAngle(const StatedValue& value) {
  return !std::holds_alternative<TomlNode::Array>(value.node.value);
}

/// Takes "initial.tilt" with angles as the angle of the scene's tilt, whose axis stays.
std::string pathOf(const VariedKey& varied, const ValueReader& file) {
  constexpr std::string_view kTilt = "initial.tilt";
  const std::string key = varied.key.text(kLongestPath);
  if (key == "body.mesh")
    varied.key.fail(key + " can't vary; [[panel]] shows several meshes side by side");
  if (key.starts_with("nudge.") && !file.find("nudge"))
    varied.key.fail(key + " is a part of a [[nudge]], and the scene states none; state it");
  const bool isWhole = key == kTilt && !std::ranges::all_of(varied.values, isAngle);
  if (isWhole || (key != kTilt && !key.starts_with(std::string(kTilt) + "."))) return key;
  if (!file.find("initial", "tilt")) {
    varied.key.fail(key + " is a part of initial.tilt, which the scene doesn't state; state it, " +
                    "such as initial.tilt = [0.01, \"z\"]");
  }
  return key == kTilt ? key + ".0" : key;
}

}  // namespace

VariedKey variedKeyFrom(const ValueReader& axis, const ValueReader& file) {
  VariedKey varied{*axis.find("key"), "", statedValues(axis)};
  requireMotionKey(varied.key);
  varied.path = pathOf(varied, file);
  return varied;
}

std::vector<physics::Model> modelsOf(const std::vector<Panel>& motions) {
  std::vector<physics::Model> models;
  for (const Panel& panel : motions) models.push_back(panel.simulation.model);
  return models;
}

void refuseUnused(const ValueReader& place, const std::string& key,
                  const std::vector<physics::Model>& models, const std::string& motions) {
  const std::string reason = reasonForNoChange(key, models);
  if (!reason.empty()) place.fail(reason + "; all " + motions + " would be the same");
}

TomlNode motionPart(const ValueReader& file) {
  TomlNode::Table sections;
  for (const auto& section : physicsSections()) {
    const auto* table = std::get_if<TomlNode::Table>(&file.node().value);
    if (const auto* entry = find(*table, section.name)) sections.push_back(*entry);
  }
  return {std::move(sections), file.node().location};
}

void put(TomlNode& sections, const VariedKey& key, const StatedValue& value) {
  putValue(sections, key.path, value.node, key.key.node().location, kMotionAlternatives);
}

VariedMotions::VariedMotions(const TomlNode& sections, Shared& shared, const VariedKey& key,
                             const Motion* known)
    : sections_(sections), shared_(shared), key_(key) {
  if (!key.path.starts_with("initial.") || findKey(key.path) == nullptr) return;
  // Without a motion of its own, whatever is wrong is found with the first value
  try {
    base_ = known != nullptr ? *known : motionFrom(sections, shared);
  } catch (const InputError&) {
    return;
  }
  // The axis of such a spin follows from the body
  if (base_->initial.about) base_.reset();
}

Motion VariedMotions::with(const StatedValue& value) const {
  const ValueReader reader(value.node, key_.path);
  if (base_ && !std::holds_alternative<TomlNode::Table>(value.node.value)) {
    Motion motion = *base_;
    readerOf(motion, key_.path, key_.key.node().location)(motion, value.node);
    failAtValue(reader, [&] { motion.initial.tilted(); });
    return motion;
  }
  TomlNode varied = sections_;
  put(varied, key_, value);
  return motionFrom(varied, shared_);
}

Motion motionFrom(const TomlNode& sections, Shared& shared) {
  const ValueReader file(sections, "");
  Motion motion;
  std::vector<document::Field> fields;
  addFields(fields, physicsSections(), motion);
  file.readTable(fields);
  checkMotion(file, motion.simulation);
  settle(file, shared, motion);
  return motion;
}

}  // namespace rotatebook::scene
