// The opening words of the source's comments.
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "house/markdown.h"

namespace rotatebook::house {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Returns the comments in `text` that begin with a subordinate clause or a pointer to their
/// neighbours, in place of a verb or noun that can be searched for.
std::vector<std::string> wrongOpeningsIn(const std::string& text) {
  static const std::regex kComment(R"(^\s*//.*)");
  static const std::regex kWrong(
      R"((^\s*///?|///<) (What|Where|Which|Whether|How|The same|That of|Those|Tells?)\b.*)");
  std::vector<std::string> wrong;
  bool isContinued = false;
  for (const std::string& line : linesOf(text)) {
    const bool isComment = std::regex_match(line, kComment);
    if (!(isComment && isContinued) && std::regex_search(line, kWrong)) wrong.push_back(line);
    isContinued = isComment;
  }
  return wrong;
}

TEST(ProseRules, TellRightFromWrong) {
  for (const std::string line :
       {"// What the book looks like.", "  /// Whether it is drawn.", "int a;  ///< How many.",
        "/// The same without graphics.", "/// Tells who can fix it."}) {
    EXPECT_THAT(wrongOpeningsIn(line), ElementsAre(line));
  }
  for (const std::string line :
       {"/// Returns what it costs.", "// Whatever is drawn.", "f(\"What\");  // Where it is.",
        "/// Draws the book, blurred\n/// Where it turns.", "bool a;  ///< True if it is drawn."}) {
    EXPECT_THAT(wrongOpeningsIn(line), IsEmpty()) << line;
  }
}

TEST(ProseRules, HoldInAllOfTheSource) {
  std::size_t seen = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(ROTATEBOOK_SOURCE) / "src")) {
    const std::string extension = entry.path().extension();
    if (extension != ".h" && extension != ".cpp" && extension != ".inc") continue;
    EXPECT_THAT(wrongOpeningsIn(readText(entry.path())), IsEmpty()) << entry.path();
    ++seen;
  }
  EXPECT_GT(seen, 400U);
}

/// Returns the captions in a scene's text in which a line's end may part a number from its unit.
std::vector<std::string> partedNumbersIn(const std::string& text) {
  static const std::regex kParted(R"(^(caption|text) = .*[0-9] (%|(kg|g|ms|s|m|cm|mm|rpm|Hz)\b))");
  std::vector<std::string> parted;
  for (const std::string& line : linesOf(text)) {
    if (std::regex_search(line, kParted)) parted.push_back(line);
  }
  return parted;
}

TEST(ProseRules, KeepNumbersOfCaptionsBesideTheirUnits) {
  EXPECT_FALSE(partedNumbersIn("caption = \"It gains 6 % of it.\"").empty());
  EXPECT_FALSE(partedNumbersIn("caption = \"In steps of 2 ms.\"").empty());
  EXPECT_FALSE(partedNumbersIn("text = \"In steps of 2 ms.\"").empty());
  EXPECT_TRUE(partedNumbersIn("caption = \"The 2 methods. 6\u00a0% of it.\"").empty());
  std::size_t seen = 0;
  for (const auto& entry :
       fs::recursive_directory_iterator(fs::path(ROTATEBOOK_SOURCE) / "scenes")) {
    if (entry.path().extension() != ".toml") continue;
    EXPECT_THAT(partedNumbersIn(readText(entry.path())), IsEmpty()) << entry.path();
    ++seen;
  }
  EXPECT_GT(seen, 40U);
}

}  // namespace
}  // namespace rotatebook::house
