#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/document/errors.h"
#include "messages.h"

namespace rotatebook::document {
namespace {

TEST(SyntaxProblem, NamesCurlyQuotes) {
  const std::string problem =
      "curly quotes, as word processors write them; write straight ones: title = \"Book\"";
  EXPECT_EQ(errorOfText("title = “Book”"), "a.toml:1:9: " + problem);
  EXPECT_EQ(errorOfText("title = ‘Book’"), "a.toml:1:9: " + problem);
  EXPECT_EQ(errorOfText("title = \"Book”"), "a.toml:1:15: " + problem);
  EXPECT_EQ(errorOfText("[overlay]\nshow = [«clock»]"), "a.toml:2:9: " + problem);
  EXPECT_EQ(errorOfText("title = \"A “book”\""), "no error");
}

TEST(SyntaxProblem, GuessesADecimalComma) {
  EXPECT_EQ(errorOfText("[initial]\nangular_velocity = [5,0 0, 0]"),
            "a.toml:2:25: a comma separates values; write 5,0 as 5.0 if that is one number");
  EXPECT_EQ(errorOfText("clip.duration = 1,5"),
            "a.toml:1:18: a comma separates values; write 1,5 as 1.5 if that is one number");
  for (const char* other : {"[5 0 0]", "5, 0, 0", "5,0,0", "[5, 0,0 0]", "5,", ",5"}) {
    const std::string message = errorOfText("[camera]\nup = " + std::string(other));
    EXPECT_MESSAGE(message) << other;
    if (other != std::string("[5, 0,0 0]")) {
      EXPECT_MESSAGE(message) << other;
    }
  }
}

// The exact column is toml++'s, and may change with its version.
TEST(SyntaxProblem, IsToldInPlainWordsAtItsPlace) {
  for (const auto& [text, problem] : std::vector<std::pair<std::string, std::string>>{
           {"title = Book", "1:9: \"Book\" isn't a value; text is in \"quotes\""},
           {"title = \"Book\n", "1:14: a string doesn't end on its line; its closing quote is"},
           {"caption = \"\"\"a\nb", ": the file ends within a value or header; a quote or bracket"},
           {"title: \"Book\"", "1:6: \":\" where = should be: lines are KEY = VALUE"},
           {"x\n", "1:2: the end of the line where = should be: lines are KEY = VALUE"},
           {"x", "1:2: a key needs = VALUE, but the file ends here"},
           {"x =", "1:4: a key needs = VALUE, but the file ends here"},
           {"\ntitle = \n", "2:9: a value is missing after ="},
           {"title = 'a' caption = 'b'", "1:13: \"caption\" after the end of a value or header"},
           {"[clip]\nfps = 30\nfps = 60\n", "3:7: stated above already; keep one of them"},
           {"[clip]\n[body]\n[clip]\n", "3:1: stated above already"},
           {"camera.up = [1,2", ": the file ends within a value or header"},
           {"5,0 = 1", "1:2: "},
           {"clip.duration = 1.5 s", "1:21: \"s\" after the end of a value or header"},
           {"clip.duration = .5", "1:17: \".5\" can't be read as a number; write one such as"},
           {"simulation.time_per_frame = 1/60",
            "1:30: \"/60\" can't be read as a number; write one such as 0.0167, without a unit or"},
           {"camera.up = [5;0;0]", "1:15: a comma separates values, not a semicolon"},
           {"angular_velocity = 5, 0, 0",
            "1:21: \",\" after the end of a value or header; lists are"},
           {"angular_velocity = (5, 0, 0)",
            "1:20: \"(5,\" isn't a value; text is in \"quotes\", a list"},
           {std::string("a = 1\0", 6), "a.toml:1:"}}) {
    const std::string message = errorOfText(text);
    EXPECT_MESSAGE(message);
    EXPECT_MESSAGE(message);
    EXPECT_MESSAGE(message);
    EXPECT_MESSAGE(message);
  }
}

// Of rare mistakes, the place, and the parser's own words.
TEST(SyntaxProblem, NamesThePlaceOfOthers) {
  for (const auto& [text, place] : std::vector<std::pair<std::string, std::string>>{
           {"[clip\n", "a.toml:1:6: the end of the line isn't TOML: expected ']'"},
           {"camera.up = [5 0 0]", "a.toml:1:16: \"0\" isn't TOML: expected comma or closing ']'"},
           {"body.normalize = True", "a.toml:1:18: \"True\" isn't TOML: expected 'true'"},
           {"title = \"a\\q\"", "a.toml:1:"},
           {"clip.duration = 05", "a.toml:1:"},
           {"x = " + std::string(3000, '['), "a.toml:1:"},
           {"# \x01", "a.toml:1:"},
           {"\n\ntitle = \"\xff\"\n", "a.toml:3:9: "}}) {
    EXPECT_MESSAGE(errorOfText(text));
  }
}

}  // namespace
}  // namespace rotatebook::document
