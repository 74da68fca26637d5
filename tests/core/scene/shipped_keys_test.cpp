#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/document/toml_tree.h"
#include "scene/key_rows.h"

namespace rotatebook::scene {
namespace {

namespace fs = std::filesystem;
using document::TomlNode;

/// Adds the row of each key below `node`, whose own name is `name`; keys of panels are those of
/// their sections, too.
void addKeys(const TomlNode& node, const std::string& name, std::set<std::string>& keys) {
  if (const KeyRow* row = findKey(name)) keys.insert(row->name);
  const auto* text = std::get_if<std::string>(&node.value);  // Of an axis
  if (const KeyRow* row = text == nullptr ? nullptr : findKey(*text)) keys.insert(row->name);
  if (const auto* table = std::get_if<TomlNode::Table>(&node.value)) {
    for (const auto& entry : *table)
      addKeys(entry.node, name.empty() ? entry.key : name + "." + entry.key, keys);
  }
  const auto* array = std::get_if<TomlNode::Array>(&node.value);
  if (array == nullptr) return;
  for (std::size_t i = 0; i < array->size(); ++i) {
    addKeys((*array)[i], name + "." + std::to_string(i), keys);
    if (name == "panel") addKeys((*array)[i], "", keys);
  }
}

TEST(ShippedScenes, ShowEachKey) {
  std::set<std::string> shown;
  for (const auto& entry : fs::recursive_directory_iterator(ROTATEBOOK_SOURCE "/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    std::ostringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    addKeys(document::parseToml(text.str(), entry.path()), "", shown);
  }
  std::set<std::string> missing;
  for (const KeyRow& row : allKeys())
    if (!shown.contains(row.name)) missing.insert(row.name);
  EXPECT_THAT(missing, ::testing::IsEmpty());
}

}  // namespace
}  // namespace rotatebook::scene
