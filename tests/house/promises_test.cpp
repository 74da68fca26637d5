// docs/tables/reliability.md: every promise is shown by tests that there are.
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "system/read_file.h"

namespace rotatebook::house {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

const fs::path kRepository = ROTATEBOOK_SOURCE;

std::vector<std::smatch> matchesIn(const std::string& text, const std::regex& pattern) {
  return {std::sregex_iterator(text.begin(), text.end(), pattern), std::sregex_iterator()};
}

/// "Suite.Test", "Suite" and "Test" of each test that `source` defines.
std::set<std::string> testsIn(const std::string& source) {
  static const std::regex kTest(R"(\bTEST(?:_F|_P)?\((\w+),\s+(\w+)\))");
  std::set<std::string> names;
  for (const std::smatch& test : matchesIn(source, kTest)) {
    names.insert({test[1], test[2], test[1].str() + '.' + test[2].str()});
  }
  return names;
}

std::set<std::string> allTests() {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(kRepository / "tests")) {
    if (entry.path().extension() == ".cpp")
      names.merge(testsIn(system::readFileOrEmpty(entry.path())));
  }
  return names;
}

/// The files and tests that a row "| promise | shown by |" names in its second cell.
std::vector<std::string> evidenceOf(const std::string& row) {
  static const std::regex kQuoted("`((?:tests/|[A-Z])[^` ]*)[^`]*`");
  const std::string cell = row.substr(row.rfind(" | ") + 3);
  std::vector<std::string> evidence;
  for (const std::smatch& quoted : matchesIn(cell, kQuoted)) evidence.push_back(quoted[1]);
  return evidence;
}

bool exists(const std::string& evidence, const std::set<std::string>& tests) {
  return evidence.starts_with("tests/") ? fs::exists(kRepository / evidence)
                                        : tests.contains(evidence);
}

/// The rows of the page's table, below its heading.
std::vector<std::string> promises() {
  std::istringstream page(system::readFileOrEmpty(kRepository / "docs/tables/reliability.md"));
  std::vector<std::string> rows;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("| ")) rows.push_back(line);
  }
  if (!rows.empty()) rows.erase(rows.begin());
  return rows;
}

TEST(Promises, AreReadWithTheirTests) {
  EXPECT_THAT(testsIn("TEST_F(Resume,\n       GoesOn) {\nTEST(Name, Other) {"),
              ElementsAre("GoesOn", "Name", "Name.Other", "Other", "Resume", "Resume.GoesOn"));
  EXPECT_THAT(
      evidenceOf(
          "| `NAME/` is whole. | `Resume.GoesOn`, `tests/kill.py --kills 3` (`make test`) |"),
      ElementsAre("Resume.GoesOn", "tests/kill.py"));
  EXPECT_FALSE(exists("tests/no_such_file.cpp", {}));
  EXPECT_FALSE(exists("Name.NoSuchTest", {"Name", "Name.Other"}));
}

TEST(Promises, AreShownByTestsThatThereAre) {
  const std::set<std::string> tests = allTests();
  const std::vector<std::string> rows = promises();
  std::vector<std::string> wrong;
  for (const std::string& promise : rows) {
    const std::vector<std::string> evidence = evidenceOf(promise);
    if (evidence.empty()) wrong.push_back(promise);
    for (const std::string& name : evidence) {
      if (!exists(name, tests)) wrong.push_back(name);
    }
  }
  EXPECT_THAT(wrong, IsEmpty());
  EXPECT_GT(rows.size(), 20U);  // measured 29
}

}  // namespace
}  // namespace rotatebook::house
