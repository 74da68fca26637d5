#include "base/document/toml_tree.h"

#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "base/document/errors.h"
#include "messages.h"

namespace rotatebook::document {
namespace {

const TomlNode::Table& tableOf(const TomlNode& node) {
  return std::get<TomlNode::Table>(node.value);
}

std::string descriptionOf(const std::string& value) {
  return describe(*parseTomlValue(value, "here"));
}

TEST(TomlTree, KeepsTheOrderOfTheText) {
  const TomlNode root = parseToml("z = 1\na = 2\n[m]\nb = 3\n", "f");
  ASSERT_EQ(tableOf(root).size(), 3u);
  EXPECT_EQ(tableOf(root)[0].key, "z");
  EXPECT_EQ(tableOf(root)[1].key, "a");
  EXPECT_EQ(tableOf(root)[2].key, "m");
}

TEST(TomlTree, KnowsThePlaceOfKeysAndValues) {
  const TomlNode root = parseToml("\n[m]\n  \"é\".b = [1,\n 2]\n", "f");
  const TomlEntry& section = tableOf(root)[0];
  EXPECT_EQ(section.keyLocation, "f:2:2");
  EXPECT_EQ(section.node.location, "f:2:1");
  const TomlEntry& dotted = tableOf(section.node)[0];
  EXPECT_EQ(dotted.key, "é");
  EXPECT_EQ(dotted.keyLocation, "f:3:3");
  const TomlEntry& last = tableOf(dotted.node)[0];
  EXPECT_EQ(last.keyLocation, "f:3:7");
  EXPECT_EQ(last.node.location, "f:3:11");
  EXPECT_EQ(std::get<TomlNode::Array>(last.node.value)[1].location, "f:4:2");
}

TEST(TomlTree, CountsColumnsInLetters) {
  const TomlNode root = parseToml("a = { b = \"é\", c = [1,\n 2] }\n", "f");
  const TomlEntry& last = tableOf(tableOf(root)[0].node)[1];
  EXPECT_EQ(last.keyLocation, "f:1:16");
  EXPECT_EQ(std::get<TomlNode::Array>(last.node.value)[1].location, "f:2:2");
}

TEST(TomlTree, GivesAllPartsOfAValueOnePlace) {
  const auto value = parseTomlValue("{ a = [1] }", "--set x={ a = [1] }");
  const TomlEntry& entry = tableOf(*value)[0];
  EXPECT_EQ(entry.keyLocation, "--set x={ a = [1] }");
  EXPECT_EQ(std::get<TomlNode::Array>(entry.node.value)[0].location, "--set x={ a = [1] }");
}

TEST(TomlTree, TakesNothingButOneValue) {
  EXPECT_TRUE(parseTomlValue("1", "here"));
  EXPECT_FALSE(parseTomlValue("", "here"));
  EXPECT_FALSE(parseTomlValue("matrix", "here"));
  EXPECT_FALSE(parseTomlValue("1\nb = 2", "here"));
}

TEST(TomlTree, DescribesEveryKindOfValue) {
  EXPECT_EQ(descriptionOf("true"), "true");
  EXPECT_EQ(descriptionOf("12"), "12");
  EXPECT_EQ(descriptionOf("10.0"), "10.0");
  EXPECT_EQ(descriptionOf("'a\"b'"), R"("a\"b")");
  EXPECT_EQ(descriptionOf("'" + std::string(201, 'x') + "'"), "a string of 201 characters");
  EXPECT_EQ(descriptionOf("1979-05-27"), "a date or time");
  EXPECT_EQ(descriptionOf("07:32:00"), "a date or time");
  EXPECT_EQ(descriptionOf("{ a = 1 }"), "a table");
  EXPECT_EQ(descriptionOf("[]"), "[]");
  EXPECT_EQ(descriptionOf("[1, 'x', [2.5], {}]"), "[1, \"x\", [2.5], a table]");
  EXPECT_EQ(descriptionOf("[1, 2, 3, 4, 5]"), "an array of 5 values");
}

TEST(TomlTree, RefusesATextWithoutEnd) {
  const std::string longest = "#" + std::string(kLongestToml - 1, ' ');
  EXPECT_TRUE(tableOf(parseToml(longest, "a.toml")).empty());
  EXPECT_EQ(errorOfText(longest + " "), "a.toml: longer than 32 KiB, the limit for a scene");
  EXPECT_EQ(errorOf([&] { parseTomlValue("'" + longest + "'", "here"); }),
            "here: longer than 32 KiB, the limit for a scene");
}

// The longest text may not exhaust the stack, however deep it nests.
TEST(TomlTree, RefusesDeepNesting) {
  std::string key = "a";
  while (key.size() + 6 < kLongestToml) key += ".a";
  EXPECT_EQ(errorOfText(key + " = 1"), "a.toml:1:17: nested deeper than any value of a scene");
  EXPECT_EQ(errorOfText("[" + key + "]"), "a.toml:1:1: nested deeper than any value of a scene");
  EXPECT_MESSAGE(errorOfText("a = " + std::string(30'000, '[')));
  EXPECT_MESSAGE(errorOfText("a = " + repeated("{a=", 300)));
  // Each as deep as it may be, and keys with dots in them.
  EXPECT_EQ(errorOfText("a = " + repeated("{a" + repeated(".a", 50) + "=", 250) + "1" +
                        std::string(250, '}')),
            "a.toml:1:20: nested deeper than any value of a scene");
}

// Characters that a terminal would obey come from quoted keys, too.
TEST(TomlTree, RepeatsNoControlCharacters) {
  EXPECT_MESSAGE(errorOfText("\"\\u001b[31m\" = 1\n\"\\u001b[31m\" = 2\n"));
}

TEST(TomlTree, RefusesLettersOutsideOfQuotes) {
  for (const char* value : {"1é", "[1é]", "é", "1979é", "1\u00a0", "1\u3000"}) {
    EXPECT_MESSAGE(errorOfText(std::string("a = ") + value + "\n")) << value;
  }
  EXPECT_EQ(describe(parseToml("a = \"\"\"\\\n  é\"\"\"", "f")), "a table");
}

TEST(TomlTree, TakesAByteOrderMarkAndForeignLineEnds) {
  EXPECT_EQ(errorOfText("\xef\xbb\xbftitle = \"a\"\r\n[initial]\r\nspin = [0, 0, 6]\r\n"),
            "no error");
}

TEST(TomlTree, IsPrintedToReadBackTheSame) {
  for (const char* text : {"[1, 2.0, \"a \\\"b\\\"\", true, [0.1]]", "{ \"every\" = 100 }", "-3"}) {
    EXPECT_EQ(tomlText(parseTomlValue(text, "f").value()), text);
  }
}

}  // namespace
}  // namespace rotatebook::document
