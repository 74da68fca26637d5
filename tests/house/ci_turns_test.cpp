// .ci/run: the turns that CI takes.
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "house/markdown.h"

namespace rotatebook::house {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAreArray;

/// A line "2 | 3) asan "picture verify" 2 $((turn - 2)) ;;" of the script.
struct Turn {
  std::vector<int> numbers;
  std::string command;
};

std::vector<Turn> turns() {
  static const std::regex kTurn(R"(^\s+([0-9 |]+)\) (.*) ;;$)"), kNumber("[0-9]+");
  std::vector<Turn> all;
  for (const std::string& line : linesOf(readText(fs::path(ROTATEBOOK_SOURCE) / ".ci/run"))) {
    std::smatch match;
    if (!std::regex_match(line, match, kTurn)) continue;
    const std::string labels = match[1];
    Turn turn{{}, match[2]};
    for (std::sregex_iterator at(labels.begin(), labels.end(), kNumber), end; at != end; ++at)
      turn.numbers.push_back(std::stoi(at->str()));
    all.push_back(turn);
  }
  return all;
}

/// The names of the tests that run with AddressSanitizer: "scene", "cli_3".
std::set<std::string> testsInTurns() {
  static const std::regex kAsan(R"re(asan "?([a-z_ ]+)"?( "_\[([0-9]+)\]")?)re");
  std::set<std::string> tests;
  for (const Turn& turn : turns()) {
    std::smatch match;
    if (!std::regex_match(turn.command, match, kAsan)) continue;
    const std::string shards = match[3];
    std::istringstream words(match[1]);
    for (std::string room; words >> room;) {
      if (shards.empty()) tests.insert(room);
      for (const char shard : shards) tests.insert(room + '_' + shard);
    }
  }
  return tests;
}

/// The names of all tests of rooms where they are sanitized.
std::set<std::string> sanitizedTests() {
  static const std::regex kTest(R"(^rotatebook_test\(([a-z_]+)(.* SANITIZED_SHARDS ([0-9]))?.*)");
  std::set<std::string> tests;
  for (const auto& entry :
       fs::recursive_directory_iterator(fs::path(ROTATEBOOK_SOURCE) / "tests")) {
    if (entry.path().filename() != "CMakeLists.txt") continue;
    for (const std::string& line : linesOf(readText(entry.path()))) {
      std::smatch match;
      if (!std::regex_match(line, match, kTest)) continue;
      const std::string room = match[1];
      if (!match[3].matched) tests.insert(room);
      for (char shard = '1'; match[3].matched && shard <= *match[3].first; ++shard)
        tests.insert(room + '_' + shard);
    }
  }
  return tests;
}

TEST(CiTurns, HaveEachRoomsTestsWithAddressSanitizer) {
  const std::set<std::string> tests = sanitizedTests();
  EXPECT_GT(tests.size(), 40U);
  EXPECT_EQ(testsInTurns(), tests);
}

TEST(CiTurns, FollowEachOtherByTheNumberOfCommits) {
  std::vector<int> numbers, wanted;
  for (const Turn& turn : turns())
    numbers.insert(numbers.end(), turn.numbers.begin(), turn.numbers.end());
  for (int i = 0; i < 20; ++i) wanted.push_back(i);
  EXPECT_THAT(numbers, ElementsAreArray(wanted));
  EXPECT_THAT(readText(fs::path(ROTATEBOOK_SOURCE) / ".ci/run"),
              ::testing::HasSubstr("turn=$(($(git rev-list --count HEAD) % 20))"));
}

// On the command line they would replace a preset's: coverage's, which count lines.
TEST(CiBuilds, LeavePresetsTheirFlags) {
  EXPECT_THAT(readText(fs::path(ROTATEBOOK_SOURCE) / "Makefile"),
              ::testing::Not(::testing::HasSubstr("-DCMAKE_CXX_FLAGS=")));
}

}  // namespace
}  // namespace rotatebook::house
