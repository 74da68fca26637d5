#include "scene/key_rows.h"

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
  add(rowsOf("study.", studyKeys()));
  return all;
}

}  // namespace rotatebook::scene
