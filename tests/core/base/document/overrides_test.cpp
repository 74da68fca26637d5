#include "base/document/overrides.h"

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "base/document/errors.h"

namespace rotatebook::document {
namespace {

/// The table `section` of `text` with `overrides`, as a message describes its values.
std::string sectionOf(const std::string& text, const std::vector<std::string>& overrides,
                      std::span<const Alternatives> alternatives = {}) {
  TomlNode root = parseToml(text, "a.toml");
  applyOverrides(root, overrides, alternatives);
  const TomlEntry* section = find(std::get<TomlNode::Table>(root.value), "section");
  std::string values;
  for (const TomlEntry& entry : std::get<TomlNode::Table>(section->node.value)) {
    values += entry.key + " = " + describe(entry.node) + "\n";
  }
  return values;
}

/// The message about `overrides` of `text`.
std::string errorWith(const std::string& text, const std::vector<std::string>& overrides) {
  TomlNode root = parseToml(text, "a.toml");
  return errorOf([&] { applyOverrides(root, overrides); });
}

TEST(Overrides, PutATableInPlaceOfAFlag) {
  TomlNode tree = parseToml("a = true", "f");
  applyOverrides(tree, std::vector<std::string>{"a.every=3"});
  const auto* a = find(std::get<TomlNode::Table>(tree.value), "a");
  EXPECT_EQ(tomlText(a->node), "{ \"every\" = 3 }");
}

TEST(Overrides, ReplaceAndAddValues) {
  EXPECT_EQ(sectionOf("section = { a = 1, b = 2 }", {"section.b=3", "section.c=bare words"}),
            "a = 1\nb = 3\nc = \"bare words\"\n");
  EXPECT_EQ(sectionOf("", {" section.a = [1, 2] ", "section.a.1=3"}), "a = [1, 3]\n");
}

TEST(Overrides, OfOneAlternativeReplaceTheOthers) {
  constexpr std::string_view kKeys[] = {"a", "b"}, kOthers[] = {"d", "e"};
  const Alternatives alternatives[] = {{"other", kOthers}, {"section", kKeys}};
  const std::string text = "section = { a = 1, b = 2, c = 3 }";
  EXPECT_EQ(sectionOf(text, {"section.b=4"}, alternatives), "b = 4\nc = 3\n");
  EXPECT_EQ(sectionOf(text, {"section.c=4"}, alternatives), "a = 1\nb = 2\nc = 4\n");
  EXPECT_EQ(sectionOf(text, {"other.a=4"}, alternatives), "a = 1\nb = 2\nc = 3\n");
}

TEST(Overrides, RefuseWhatHasNoForm) {
  EXPECT_EQ(errorWith("", {"simulation.substeps"}),
            "--set simulation.substeps: expected KEY=VALUE");
  EXPECT_EQ(errorWith("", {""}), "--set : expected KEY=VALUE");
  EXPECT_EQ(errorWith("", {"=3"}), "--set =3: the key, or a part of it, is empty");
  EXPECT_EQ(errorWith("", {"clip.=3"}), "--set clip.=3: the key, or a part of it, is empty");
  EXPECT_EQ(errorWith("", {".clip=3"}), "--set .clip=3: the key, or a part of it, is empty");
  EXPECT_EQ(errorWith("", {"clip..fps=3"}),
            "--set clip..fps=3: the key, or a part of it, is empty");
  EXPECT_EQ(errorWith("", {"a.b.c.d.e.f.g=3"}),
            "--set a.b.c.d.e.f.g=3: no key of a scene has more than six parts");
  EXPECT_EQ(errorWith("", {"title=\xff"}), "--set title=\uFFFD: the value isn't UTF-8");
}

TEST(Overrides, PutAValueWithALocationOfItsOwn) {
  TomlNode root = parseToml("[a]\nb = 1\n", "f");
  putValue(root, "a.c.d", {std::int64_t{2}, "f:9:9"}, "f:8:8");
  EXPECT_EQ(tomlText(root), "{ \"a\" = { \"b\" = 1, \"c\" = { \"d\" = 2 } } }");
  EXPECT_EQ(errorOf([&] {
              putValue(root, "a.b.d", {std::int64_t{2}, "f:9:9"}, "f:8:8");
            }),
            "f:8:8: a.b is 1, which has no keys");
}

TEST(Overrides, AreCounted) {
  EXPECT_EQ(errorWith("", std::vector<std::string>(1000, "a=3")), "no error");
  EXPECT_EQ(errorWith("", std::vector<std::string>(1001, "a=3")),
            "--set: 1001 options; the limit is 1000; write the values into the scene's file");
}

TEST(Overrides, RefuseAWayThroughAValue) {
  EXPECT_EQ(errorWith("title = \"x\"", {"title.size=3"}),
            "--set title.size=3: title is \"x\", which has no keys");
  EXPECT_EQ(errorWith("expect.half_turns = [{ min = 1 }]", {"expect.half_turns.min=3"}),
            "--set expect.half_turns.min=3: expect.half_turns has 1 element, numbered from 0, and "
            "no \"min\"");
}

}  // namespace
}  // namespace rotatebook::document
