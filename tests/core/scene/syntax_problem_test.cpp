#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/parse.h"

namespace rotatebook::scene {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

TEST(SyntaxProblem, NamesCurlyQuotes) {
  const std::string problem =
      "curly quotes, as word processors write them; write straight ones: title = \"Book\"";
  EXPECT_EQ(errorOf("title = “Book”"), "a.toml:1:9: " + problem);
  EXPECT_EQ(errorOf("title = ‘Book’"), "a.toml:1:9: " + problem);
  EXPECT_EQ(errorOf("title = \"Book”"), "a.toml:1:15: " + problem);
  EXPECT_EQ(errorOf("[overlay]\nshow = [«clock»]"), "a.toml:2:9: " + problem);
  EXPECT_EQ(errorOf("title = \"A “book”\""), "no error");
}

TEST(SyntaxProblem, GuessesADecimalComma) {
  EXPECT_EQ(errorOfText("[initial]\nangular_velocity = [5,0 0, 0]"),
            "a.toml:2:25: a comma separates values; write 5,0 as 5.0 if that is one number");
  EXPECT_EQ(errorOf("clip.duration = 1,5"),
            "a.toml:1:18: a comma separates values; write 1,5 as 1.5 if that is one number");
  for (const char* other : {"[5 0 0]", "5, 0, 0", "5,0,0", "[5, 0,0 0]", "5,", ",5"}) {
    const std::string message = errorOf("[camera]\nup = " + std::string(other));
    EXPECT_THAT(message, StartsWith("a.toml:2:")) << other;
    if (other != std::string("[5, 0,0 0]")) {
      EXPECT_THAT(message, Not(HasSubstr("write"))) << other;
    }
  }
}

// The exact column is toml++'s, and may change with its version.
TEST(SyntaxProblem, IsToldInPlainWordsAtItsPlace) {
  for (const auto& [text, problem] : std::vector<std::pair<std::string, std::string>>{
           {"title = Book", "1:9: \"Book\" isn't a value; text is in \"quotes\""},
           {"title = \"Book\n", "1:14: a string doesn't end on its line; its closing quote is"},
           {"caption = \"\"\"a\nb", ": the file ends within a value"},
           {"title: \"Book\"", "1:6: \":\" where = should be: lines are KEY = VALUE"},
           {"\ntitle = \n", "2:9: a value is missing after ="},
           {"title = 'a' caption = 'b'", "1:13: \"caption\" after the end of a value or header"},
           {"[clip]\nfps = 30\nfps = 60\n", "3:7: stated above already; keep one of them"},
           {"[clip]\n[body]\n[clip]\n", "3:1: stated above already"},
           {"[clip\n", "1:6: a header's closing ] is missing before the end of the line"},
           {"camera.up = [1,2", ": the file ends within a value"},
           {"5,0 = 1", "1:2: "},
           {"camera.up = [5 0 0]", "1:16: a comma or the closing ] is missing before \"0\""},
           {"clip.duration = 1.5 s", "1:21: \"s\" after the end of a value or header"},
           {"clip.duration = .5", "1:17: a number needs a digit on each side of its point"},
           {"clip.duration = 05", ": a number can't begin with a needless zero"},
           {"clip.fps = 30/1001", "1:14: \"/1001\" isn't part of a number; units aren't written"},
           {"body.normalize = True", "1:18: \"True\" isn't a value; true is written in small"},
           {"title = \"a\\q\"", ": an unknown escape; a backslash in quotes is written"},
           {"clip.duration = 1e400", "a number beyond the range of numbers"},
           {"x = " + std::string(3000, '['), "values are nested too deep"},
           {"angular_velocity = 5, 0, 0",
            "1:21: \",\" after the end of a value or header; lists are"},
           {"angular_velocity = (5, 0, 0)",
            "1:20: \"(5,\" isn't a value; text is in \"quotes\", a list"},
           {"# \x01", ": a control character; in quotes, write it as an escape"},
           {"\n\ntitle = \"\xff\"\n", "3:9: not UTF-8; save the file as UTF-8"},
           {std::string("a = 1\0", 6), "a.toml:1:"}}) {
    const std::string message = errorOfText(text);
    EXPECT_THAT(message, HasSubstr(problem));
    EXPECT_THAT(message, StartsWith("a.toml:"));
    EXPECT_THAT(message, Not(HasSubstr("Error while parsing")));
    EXPECT_THAT(message, Not(HasSubstr("\n")));
  }
}

}  // namespace
}  // namespace rotatebook::scene
