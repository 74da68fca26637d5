// Reads [[panel]], the motions that a clip shows side by side.
#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "base/document/problems.h"
#include "base/document/toml_text.h"
#include "scene/keys/keys.h"
#include "scene/names.h"
#include "scene/placed_particles.h"
#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

using document::TomlEntry;
using document::TomlNode;

const TomlNode::Table* tableOf(const TomlNode& node) {
  return std::get_if<TomlNode::Table>(&node.value);
}

const TomlNode::Table* tableOf(const ValueReader& parent, std::string_view key) {
  const auto value = parent.find(key);
  return value ? tableOf(value->node()) : nullptr;
}

/// Returns whether `own`, a panel's section, replaces `entry` of the scene's: with the same key, or
/// with another of which a motion has only one.
bool replaces(const TomlNode::Table& own, std::string_view section, const TomlEntry& entry) {
  return std::ranges::any_of(own, [&](const TomlEntry& mine) {
    return mine.key == entry.key ||
           areAlternatives(kMotionAlternatives, section, mine.key, entry.key);
  });
}

/// Adds to a panel's sections what the scene's section `name` has and the panel's doesn't.
void mergeSection(TomlNode::Table& sections, std::string_view name, const TomlNode& common) {
  // Take the scene's section whole if the panel has none
  TomlEntry* section = find(sections, name);
  if (section == nullptr) {
    sections.push_back({std::string(name), common.location, common});
    return;
  }

  // Leave what isn't a table to the section's reader, which refuses it
  const TomlNode::Table* shared = tableOf(common);
  auto* own = std::get_if<TomlNode::Table>(&section->node.value);
  if (own == nullptr || shared == nullptr) return;

  // Append the scene's keys that the panel, as it was written, doesn't replace
  const TomlNode::Table before = *own;
  for (const TomlEntry& entry : *shared) {
    if (!replaces(before, name, entry)) own->push_back(entry);
  }
}

/// Returns a panel with all keys that the scene has for it. Every value keeps its location.
TomlNode mergedPanel(const ValueReader& panel, const ValueReader& file) {
  TomlNode merged = panel.node();
  auto& sections = std::get<TomlNode::Table>(merged.value);
  for (const auto& section : motionSections()) {
    const auto common = file.find(section.name);
    if (common) mergeSection(sections, section.name, common->node());
  }
  return merged;
}

/// Throws InputError if a panel states what all panels share.
void refuseShared(const ValueReader& panel) {
  if (const auto clip = panel.find("clip")) {
    clip->fail(
        "a panel has no clip of its own, because all panels share one clock; set the keys of "
        "[clip] for the whole scene");
  }
  const auto simulation = panel.find("simulation");
  if (!simulation) return;
  if (const auto time = simulation->find("time_per_frame")) {
    time->fail(
        "a panel has no time_per_frame of its own, because all panels share one clock; set "
        "simulation.time_per_frame for the whole scene");
  }
}

void refuseSameLabel(const ValueReader& label, const std::vector<Panel>& earlier,
                     const Panel& panel) {
  for (const Panel& other : earlier) {
    if (other.label == panel.label) {
      label.fail("two panels have the label " + tomlString(panel.label));
    }
  }
}

void requireStart(const ValueReader& panel, const ValueReader& merged, const Panel& read) {
  const auto initial = merged.find("initial");
  if (!initial) {
    panel.fail("the panel " + tomlString(read.label) +
               " has no [initial], and neither has the scene; it needs angular_velocity or "
               "angular_momentum");
  }
  requireSpin(*initial);
}

/// Checks `read`, a panel read from `merged`, across its sections. Throws InputError.
void checkPanel(const ValueReader& panel, const ValueReader& merged, const Panel& read) {
  // Require what has no default: a label and a spin
  if (!panel.find("label")) panel.fail("a panel needs a label");
  if (read.simulation.model == physics::Model::Recorded) {
    checkRecorded(merged, panel, read.simulation);
  } else {
    requireStart(panel, merged, read);
  }

  // Refuse a body that the model doesn't take
  if (const auto body = merged.find("body")) checkParticlesBody(*body, read.simulation);

  // Refuse an integrator that the model doesn't have, unless the scene states it for other panels
  // and this one takes no steps
  const auto simulation = merged.find("simulation");
  if (!simulation) return;
  const TomlNode::Table* own = tableOf(panel, "simulation");
  const bool isOwn = own != nullptr && find(*own, "integrator") != nullptr;
  if (isOwn || physics::takesSteps(read.simulation.model)) {
    checkIntegrator(*simulation, read.simulation);
  }
  checkDissipation(*simulation, read.simulation);
}

Panel readPanel(const ValueReader& panel, const ValueReader& file,
                const std::vector<Panel>& earlier) {
  // Complete the panel's sections from the scene's
  refuseShared(panel);
  const TomlNode node = mergedPanel(panel, file);
  const ValueReader merged(node, panel.name());

  // Read the keys of the panel itself and of its sections
  Panel result;
  auto fields = fieldsOf(panelKeys(), [&](const Key<Panel>& key, const ValueReader& value) {
    key.read(value, result);
    if (key.name == "label") refuseSameLabel(value, earlier, result);
  });
  addFields(fields, motionSections(), result);
  merged.readTable(fields);

  result.locations = document::locationsOf(node);

  // Check what several sections decide together
  checkPanel(panel, merged, result);
  return result;
}

}  // namespace

std::vector<Panel> readPanels(const ValueReader& panels, const ValueReader& file) {
  const auto tables = panels.tables("tables with the header [[panel]]");
  if (tables.size() < kMinPanels || tables.size() > kMaxPanels) {
    panels.fail("a scene has " + std::to_string(kMinPanels) + " to " + std::to_string(kMaxPanels) +
                " panels, not " + std::to_string(tables.size()));
  }
  std::vector<Panel> result;
  document::Problems problems;
  for (const ValueReader& table : tables) {
    problems.note([&] { result.push_back(readPanel(table, file, result)); });
  }
  problems.throwIfAny();
  return result;
}

}  // namespace rotatebook::scene
