#include "scene/toml_text.h"

#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace rotatebook::scene {
namespace {

TEST(TomlString, EscapesWhatTomlForbids) {
  EXPECT_EQ(tomlString("plain é"), "\"plain é\"");
  EXPECT_EQ(tomlString("\"\\\n\t"), R"("\"\\\n\t")");
  EXPECT_EQ(tomlString(std::string("\x01\x1f\x7f\0", 4)), R"("\u0001\u001F\u007F\u0000")");
}

TEST(TomlString, EscapesTheControlCharactersOfLatin1) {
  EXPECT_EQ(tomlString("\u0080\u009b\u009f\u00a0"), "\"\\u0080\\u009B\\u009F\u00a0\"");
  EXPECT_EQ(tomlString("\xc2"), "\"\xc2\"");
}

TEST(Printable, LeavesATerminalNothingToObey) {
  EXPECT_EQ(printable("a\x1b[31m\u009b\x7f"), "a\\u001B[31m\\u009B\\u007F");
  EXPECT_EQ(printable("\"é\" \\ two\nlines\t"), "\"é\" \\ two\nlines\t");
}

TEST(OneLine, HasNoEndsOfLinesAndNoMoreThanItMay) {
  EXPECT_EQ(oneLine("\"é\" \\ two\nlines\t\x1b", 99), "\"é\" \\ two\\nlines\\t\\u001B");
  EXPECT_EQ(oneLine("aé本📖", 4), "aé本📖");
  EXPECT_EQ(oneLine("aé本📖", 3), "aé本...");
  EXPECT_EQ(oneLine("", 0), "");
  EXPECT_EQ(oneLine(std::string(99, '\x80'), 2), std::string(8, '\x80') + "...");
}

TEST(LetterCount, CountsLettersNotBytes) {
  EXPECT_EQ(letterCount(""), 0u);
  EXPECT_EQ(letterCount("aé本📖"), 4u);
}

TEST(TomlNumber, IsAlwaysAFloat) {
  EXPECT_EQ(tomlNumber(2), "2.0");
  EXPECT_EQ(tomlNumber(-0.0), "-0.0");
  EXPECT_EQ(tomlNumber(0.1), "0.1");
  EXPECT_EQ(tomlNumber(1e100), "1e+100");
  // All digits, and too many of them for a TOML integer.
  EXPECT_EQ(tomlNumber(1180591620717411303424.0), "1180591620717411303424.0");
}

TEST(TomlNumber, NamesWhatIsNotFinite) {
  EXPECT_EQ(tomlNumber(-std::numeric_limits<double>::infinity()), "-inf");
  EXPECT_EQ(tomlNumber(std::numeric_limits<double>::quiet_NaN()), "nan");
}

}  // namespace
}  // namespace rotatebook::scene
