// Each setting that a scene's keys fill is used: a key that is read and printed, and then does
// nothing, fails here.
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "house/source_tree.h"

namespace rotatebook::house {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;

/// The headers, below src/, of the structs that keys fill.
const std::set<fs::path> kSettings{
    "core/physics/motion_settings.h",
    "core/physics/nudge.h",
    "core/scene/scene.h",
    "core/scene/moment.h",
    "core/scene/expectation.h",
    "core/scene/axis.h",
    "core/scene/grid_settings.h",
    "core/scene/map_settings.h",
    "core/scene/solid.h",
    "core/scene/study_settings.h",
};

/// Returns the text of a file without comments and strings.
std::string codeOf(const fs::path& path) {
  static const std::regex kWords(R"(//[^\n]*|"(\\.|[^"\\\n])*")");
  std::ifstream stream(path);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  return std::regex_replace(text, kWords, "");
}

/// Returns the members that the structs of `code` declare.
std::set<std::string> membersIn(const std::string& code) {
  static const std::regex kDeclaration(
      R"(\n  (?!friend|return|using|static|enum|if|for|case|struct)[\w:]+(<[^;()]*>)?[ &*]+([^;()\n]*);)");
  static const std::regex kValue(R"(\{[^}]*\}|=[^,]*)");
  static const std::regex kName(R"(\w+)");
  std::set<std::string> members;
  for (std::sregex_iterator found(code.begin(), code.end(), kDeclaration), end; found != end;
       ++found) {
    const std::string names = std::regex_replace((*found)[2].str(), kValue, "");
    members.insert(std::sregex_token_iterator(names.begin(), names.end(), kName),
                   std::sregex_token_iterator());
  }
  return members;
}

/// Returns whether a source only carries settings from text to text.
bool onlyCarries(const fs::path& path) {
  const std::string name = path.filename().string();
  return path.parent_path() == "core/scene/keys" || name.ends_with("_section.cpp") ||
         name == "scene_text.cpp" || name == "scene_reader.cpp" || kSettings.contains(path);
}

std::set<std::string> wordsOfConsumers() {
  static const std::regex kWord(R"([A-Za-z_]\w*)");
  std::set<std::string> words;
  for (const fs::path& path : filesBelow(kSource)) {
    if (onlyCarries(path.lexically_relative(kSource))) continue;
    const std::string code = codeOf(path);
    words.insert(std::sregex_token_iterator(code.begin(), code.end(), kWord),
                 std::sregex_token_iterator());
  }
  // A setting may be used by a function beside it.
  std::string settings;
  for (const fs::path& header : kSettings) settings += codeOf(kSource / header);
  std::set<std::string> once;
  for (std::sregex_token_iterator word(settings.begin(), settings.end(), kWord), end; word != end;
       ++word) {
    if (!once.insert(*word).second) words.insert(*word);
  }
  return words;
}

std::vector<std::string> unused(const std::set<std::string>& members,
                                const std::set<std::string>& words) {
  std::vector<std::string> missing;
  std::ranges::set_difference(members, words, std::back_inserter(missing));
  return missing;
}

TEST(KeyConsumers, KnowTheMembersOfSettings) {
  EXPECT_THAT(membersIn("struct Camera {\n  double rollDeg = 0;\n  int width{}, height = 2;\n"
                        "  bool isSet() const;\n};\n"),
              ElementsAre("height", "rollDeg", "width"));
  std::set<std::string> all;
  for (const fs::path& header : kSettings) all.merge(membersIn(codeOf(kSource / header)));
  EXPECT_THAT(all, IsSupersetOf({"fieldOfViewDeg", "substeps", "motionBlur", "curves", "film"}));
}

TEST(KeyConsumers, FindWhatNobodyUses) {
  EXPECT_THAT(unused({"rollDeg", "width"}, wordsOfConsumers()), ElementsAre("rollDeg"));
}

TEST(KeyConsumers, UseEachMemberOfSettings) {
  const std::set<std::string> words = wordsOfConsumers();
  for (const fs::path& header : kSettings) {
    EXPECT_THAT(unused(membersIn(codeOf(kSource / header)), words), IsEmpty()) << header;
  }
}

}  // namespace
}  // namespace rotatebook::house
