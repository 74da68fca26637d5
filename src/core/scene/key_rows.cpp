#include "scene/key_rows.h"

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "scene/keys/keys.h"
#include "scene/names.h"
#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

std::vector<KeyRow> collectedKeys() {
  std::vector<KeyRow> all = rowsOf("", titleKeys());
  const auto add = [&all](std::vector<KeyRow> rows, bool ofMotion = false) {
    for (KeyRow& row : rows) {
      row.mayVary = ofMotion && row.affects == Affects::Motion;
      all.push_back(std::move(row));
    }
  };
  for (const auto& section : motionSections()) add(section.rows, true);
  for (const auto& section : pictureSections()) add(section.rows);
  add(rowsOf("panel.N.", panelKeys()));
  add(rowsOf("grid.", gridKeys()));
  add(rowsOf("study.", studyKeys()));
  add(rowsOf("map.", mapKeys()));
  return all;
}

/// Returns the key without the numbers of elements, and without its last part if `isPart`.
std::string rowName(std::string_view key, bool isPart) {
  std::vector<std::string> parts = itemsOf(key, '.');
  for (std::size_t i = 0; i + 1 < parts.size(); ++i)
    if (parts[i].find_first_not_of("0123456789") == std::string::npos) parts[i] = "N";
  if (isPart) parts.pop_back();
  return joined(parts, ".");
}

}  // namespace

const std::vector<KeyRow>& allKeys() {
  static const std::vector<KeyRow> rows = collectedKeys();
  return rows;
}

const KeyRow* findKey(std::string_view key) {
  for (const bool isPart : {false, true}) {
    const auto row = std::ranges::find(allKeys(), rowName(key, isPart), &KeyRow::name);
    if (row != allKeys().end()) return &*row;
  }
  return nullptr;
}

std::string reasonForNoChange(std::string_view key, std::span<const physics::Model> models) {
  const KeyRow* row = findKey(key);
  const auto changes = [row](physics::Model model) { return row->models.have(model); };
  if (row == nullptr || std::ranges::any_of(models, changes)) return "";
  if (row->models == kOfParticles) return std::string(key) + " is of the model \"particles\" alone";
  return std::string(key) + ": the model " + tomlString(nameOf(kModels, models.front())) +
         (row->models == kOfStepwise ? " takes no steps" : " doesn't have it");
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

std::string sectionsOf(std::string_view key) {
  std::vector<std::string> sections;
  for (const KeyRow& row : allKeys()) {
    const std::size_t dot = row.name.rfind('.');
    if (std::string_view(row.name).substr(dot + 1) != key) continue;  // npos + 1 is 0
    if (dot == row.name.npos) return "before the first [section]";
    const std::string section = row.name.substr(0, dot);
    const bool isArray = section.ends_with(".N");
    sections.push_back(isArray ? "[[" + section.substr(0, section.size() - 2) + "]]"
                               : "[" + section + "]");
  }
  return sections.empty() ? "" : "under " + listed(sections, "or");
}

}  // namespace rotatebook::scene
