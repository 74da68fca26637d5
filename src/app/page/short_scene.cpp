#include "page/short_scene.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "scene/scene_text.h"

namespace rotatebook::page {
namespace {

/// A scene with nothing but what each needs.
constexpr std::string_view kPlainScene = "[initial]\nangular_velocity = [1, 0, 0]\n";

/// A section of a scene's text, with the lines of its keys; the first has no heading.
struct Section {
  std::string heading;
  std::vector<std::string> lines;
};

std::vector<Section> sectionsOf(const std::string& text) {
  std::vector<Section> sections(1);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    line.resize(std::min(line.size(), line.find("  # ")));
    if (line.starts_with('[')) {
      sections.push_back({line, {}});
    } else if (!line.empty()) {
      sections.back().lines.push_back(line);
    }
  }
  return sections;
}

/// Returns the heading that `heading` has outside panels.
std::string outsidePanels(std::string heading) {
  constexpr std::string_view kInPanel = "[panel.";
  return heading.starts_with(kInPanel) ? heading.replace(0, kInPanel.size(), "[") : heading;
}

/// The lines of each section that say what is so without them.
using DefaultLines = std::map<std::string, std::set<std::string>>;

const DefaultLines& defaultLines() {
  static const DefaultLines all = [] {
    DefaultLines found;
    for (const Section& section : sectionsOf(sceneText(scene::parseScene(kPlainScene, ".toml"))))
      found[section.heading] = {section.lines.begin(), section.lines.end()};
    found.erase("[initial]");
    return found;
  }();
  return all;
}

/// Returns the section's lines that its scene needs.
std::vector<std::string> neededLines(const Section& section) {
  const std::string heading = outsidePanels(section.heading);
  const auto known = defaultLines().find(heading);
  if (known == defaultLines().end()) return section.lines;
  std::vector<std::string> needed;
  std::ranges::copy_if(section.lines, std::back_inserter(needed),
                       [&](const std::string& line) { return !known->second.contains(line); });
  // Another body may have other defaults than the book
  return heading == "[body]" && !needed.empty() ? section.lines : needed;
}

std::string withoutDefaults(const std::string& text) {
  std::string rest;
  for (const Section& section : sectionsOf(text)) {
    const std::vector<std::string> lines = neededLines(section);
    if (lines.empty() && !section.heading.starts_with("[[")) continue;
    if (!section.heading.empty()) rest += '\n' + section.heading + '\n';
    for (const std::string& line : lines) rest += line + '\n';
  }
  return rest;
}

/// Returns whether `text`, a scene's, reads back as the scene whose whole text is `whole`.
bool isOf(const std::string& whole, const std::string& text, const std::string& name) {
  try {
    return sceneText(scene::parseScene(text, name + ".toml")) == whole;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

std::string shortText(const scene::Scene& scene) {
  const std::string whole = sceneText(scene);
  std::string text = withoutDefaults(whole);
  // A default may follow from other keys, and a text may look like a comment
  return isOf(whole, text, scene.name) ? text : whole;
}

}  // namespace rotatebook::page
