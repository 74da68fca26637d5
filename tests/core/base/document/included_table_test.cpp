#include "base/document/included_table.h"

#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "base/document/errors.h"

namespace rotatebook::document {
namespace {

/// "FILE, VALUE" of section.key in `text`, whose folder has a.words with `words`.
std::string included(const std::string& text, const std::string& words) {
  TomlNode root = parseToml(text, "in/a.toml");
  const auto file = includeTable(
      root, "section", "key", "in", [&](const std::filesystem::path& name, std::size_t) {
        if (name == "a.words") return words;
        throw InputError("can't read in/" + name.string() + ": it isn't there");
      });
  const TomlEntry* section = find(std::get<TomlNode::Table>(root.value), "section");
  const auto* table = section ? std::get_if<TomlNode::Table>(&section->node.value) : nullptr;
  const TomlEntry* entry = table ? find(*table, "key") : nullptr;
  return file.string() + ", " + (entry ? tomlText(entry->node) : "nothing");
}

std::string errorWith(const std::string& text, const std::string& words = "") {
  return errorOf([&] { included(text, words); });
}

TEST(IncludedTable, ReplacesTheNameOfItsFile) {
  EXPECT_EQ(included("section.key = 'a.words'", "x = 1\ny = 'b'"),
            "in/a.words, { \"x\" = 1, \"y\" = \"b\" }");
}

TEST(IncludedTable, LeavesWhatNamesNoFile) {
  for (const char* value : {"\"german\"", "{ \"x\" = 1 }", "2.5"}) {
    EXPECT_EQ(included(std::string("section.key = ") + value, ""), std::string(", ") + value);
  }
  EXPECT_EQ(included("section.other = 'a.words'", ""), ", nothing");
  EXPECT_EQ(included("section = 'a.words'", ""), ", nothing");
  EXPECT_EQ(included("other.key = 'a.words'", ""), ", nothing");
}

TEST(IncludedTable, KeepsItsLocations) {
  TomlNode root = parseToml("section.key = 'a.words'", "in/a.toml");
  includeTable(root, "section", "key", "in", [](const auto&, std::size_t) { return "\n  x = 1"; });
  const TomlEntry* section = find(std::get<TomlNode::Table>(root.value), "section");
  const TomlEntry* entry = find(std::get<TomlNode::Table>(section->node.value), "key");
  EXPECT_EQ(std::get<TomlNode::Table>(entry->node.value)[0].keyLocation, "in/a.words:2:3");
}

TEST(IncludedTable, IsRefusedAtItsNameOrWithinItsFile) {
  EXPECT_EQ(errorWith("section.key = 'b.words'"),
            "in/a.toml:1:15: can't read in/b.words: it isn't there");
  EXPECT_EQ(errorWith("section.key = '/a.words'"),
            "in/a.toml:1:15: section.key names the file \"/a.words\", which must be relative to "
            "the scene's folder");
  EXPECT_EQ(errorWith("section.key = 'a.words'", "x = 1\ny = z\n").find("in/a.words:2:5: "), 0U);
  TomlNode root = parseToml("section.key = 'a.words'", "a.toml");
  EXPECT_EQ(errorOf([&] { includeTable(root, "section", "key", "", {}); }),
            "a.toml:1:15: section.key names the file \"a.words\", but no file is read here; write "
            "its table instead");
}

}  // namespace
}  // namespace rotatebook::document
