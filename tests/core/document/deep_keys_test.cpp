#include "document/deep_keys.h"

#include <chrono>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "document/errors.h"

namespace rotatebook::document {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string keyOf(int parts, const std::string& part = "a") {
  return part + repeated("." + part, parts - 1);
}

/// A text with a key in it.
struct Around {
  std::string before;
  std::string after;
};

// What is too deep to be parsed has the message and the place of what can be, and is just too deep.
TEST(DeepKeys, HaveThePlaceThatTheParserFinds) {
  for (const auto& [before, after] : std::vector<Around>{
           {"", " = 1"},
           {"\xef\xbb\xbf", " = 1\n"},
           {"title = \"é # [\"\n# a.b\n\n  \"é\".\"a.b\" . 'c' .", "= [1, 2]\n"},
           {"[", "]"},
           {"a = 1\n [ x.", " ] # end\nb = 2\n"},
           {"[[x.", "]]\n"},
           {"[clip]\nfps = 1.5\n", " = 1"},
           {"[a.b.c.d]\n\"é\".", " = 1"},
           {"[[panel]]\n", " = 1"},
           {"a = {b = 1.5, \"é\".", " = 2}"},
           {"[x]\na = {b = {c = ['}', {d = 1}, {\"é\".", " = 2}]}}"},
           {"a = [[\n1], [[[[[[{", " = 1}]]]]]]]"},
           {"z = '''\n'' ' \\'''\nb = \"\"\"\\\" \"\"\n\"\"\"\"\"\nc = ''\nd = \"\\\"\"\n", "=1"},
       }) {
    const std::string shallow = errorOfText(before + keyOf(30) + after);
    ASSERT_THAT(shallow, HasSubstr(": nested deeper than any value of a scene"));
    for (const int parts : {500, 600, 15'000}) {
      EXPECT_EQ(errorOfText(before + keyOf(parts) + after), shallow) << before << parts;
    }
  }
}

TEST(DeepKeys, AddUpInOneAnother) {
  const auto text = [](int inside) {
    return "[h.h]\n" + repeated("a.b.c = [{", inside) + "d = 1" + repeated("}]", inside) + "\n";
  };
  EXPECT_EQ(farTooDeep(text(100), 8), std::nullopt);
  EXPECT_EQ(farTooDeep(text(140), 8), text(140).find('[', 17)) << "after 2, 3, 1 and 2 levels";
  EXPECT_EQ(errorOfText(text(140)), errorOfText(text(10)));
  EXPECT_EQ(errorOfText("[" + keyOf(400) + "]\n" + keyOf(400, "b") + " = 1"),
            errorOfText("[" + keyOf(20) + "]"));
}

TEST(DeepKeys, ArentRowsOfDotsElsewhere) {
  const std::string dots = repeated(".a", 2000);
  for (const std::string& text : std::vector<std::string>{
           "a = \"" + dots + "\"", "a = '" + dots + "'", "# " + dots, "a = 1 # " + dots,
           "a = \"\"\"\n" + dots + "\n\\\"\"\"" + dots + "\"\"\"\"\"\nb = 1",
           "a = '''\n" + dots + "\\\n''" + dots + "'''''\n", "\"" + dots + "\" = 1",
           "'" + dots + "'.b = [\"" + dots + "\"]", "x = [" + repeated("1.5,\n", 2000) + "]"}) {
    EXPECT_EQ(farTooDeep(text, 8), std::nullopt) << text.substr(0, 20);
    EXPECT_EQ(errorOfText(text), "no error") << text.substr(0, 20);
  }
  std::string lines;
  for (int i = 0; i < 600; ++i) lines += "k" + std::to_string(i) + ".a.b = {c.d = 1.5}\n";
  EXPECT_EQ(farTooDeep(lines, 8), std::nullopt) << "side by side";
}

TEST(DeepKeys, LeaveWhatIsntTomlToTheParser) {
  const std::string deep = keyOf(2000) + " = 1";
  for (const char* before : {"a = \"b\n", "]\n", ",\n", "a = [1\n[", "a = \"\"\"\n", "[a\n"}) {
    EXPECT_THAT(errorOfText(std::string(before) + deep),
                AllOf(StartsWith("a.toml:"), HasSubstr(": ")));
  }
  EXPECT_EQ(errorOfText("a = " + deep).substr(0, 12), "a.toml:1:5: ");
  for (const char* text :
       {"", "\"", "'''", "\"\\", "a = \"\"\"\\", "[", "[[", "[[a]", "{", "}", "="}) {
    EXPECT_EQ(farTooDeep(text, 8), std::nullopt) << text;
  }
}

// Longer ones are too long.
TEST(DeepKeys, AreRefusedAtOnce) {
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(errorOfText(keyOf(15'000) + " = 1"),
            "a.toml:1:17: nested deeper than any value of a scene");
  EXPECT_EQ(errorOfText(keyOf(1'000'000) + " = 1"),
            "a.toml: longer than 32 KiB, the limit for a scene");
  EXPECT_EQ(farTooDeep(keyOf(1'000'000) + " = 1", 8), 16u);
  EXPECT_EQ(farTooDeep("a = '" + std::string(2'000'000, '.') + "'", 8), std::nullopt);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  EXPECT_LT(took.count(), 1.0) << "measured 0.01 s";
}

}  // namespace
}  // namespace rotatebook::document
