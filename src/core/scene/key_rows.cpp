#include "scene/key_rows.h"

#include "base/text.h"
#include "scene/keys/keys.h"
#include "scene/sections.h"

namespace rotatebook::scene {

std::vector<KeyRow> allKeys() {
  std::vector<KeyRow> all = rowsOf("", titleKeys());
  const auto add = [&all](const std::vector<KeyRow>& rows) {
    all.insert(all.end(), rows.begin(), rows.end());
  };
  for (const auto& section : motionSections()) add(section.rows);
  for (const auto& section : pictureSections()) add(section.rows);
  add(rowsOf("panel.N.", panelKeys()));
  add(rowsOf("grid.", gridKeys()));
  add(rowsOf("study.", studyKeys()));
  add(rowsOf("study.", sweepKeys()));
  add(rowsOf("study.", samplingKeys()));
  add(rowsOf("map.", mapKeys()));
  return all;
}

std::string sectionsOf(std::string_view key) {
  static const std::vector<KeyRow> rows = allKeys();
  std::vector<std::string> sections;
  for (const KeyRow& row : rows) {
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
