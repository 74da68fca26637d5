#include "scene/key_rows.h"

#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/axis.h"
#include "scene/parse.h"

namespace rotatebook::scene {
namespace {

using ::testing::HasSubstr;

bool isOfExpect(const KeyRow& row) {
  return row.name.starts_with("expect.");
}

/// The rows of docs/tables/keys.md, whose links lead out of its folder.
std::string keyTable() {
  std::string table;
  for (const KeyRow& row : allKeys()) {
    if (isOfExpect(row)) continue;
    table += "| `" + row.name + "` | " + row.byDefault + " | " + row.allowed + " | " + row.meaning +
             " |\n";
  }
  table = std::regex_replace(table, std::regex(R"(\]\((?=[a-z-]+\.md))"), "](../");
  return std::regex_replace(table, std::regex(R"(\]\(#)"), "](../scene.md#");
}

std::string quantityTable() {
  std::string table;
  for (const KeyRow& row : allKeys()) {
    if (!isOfExpect(row)) continue;
    table += "| `" + row.name.substr(row.name.find('.') + 1) + "` | " + row.meaning + " |\n";
  }
  return table;
}

/// The rows of the tables in a page below the heading `from` and above the heading `to`.
std::string documentedRows(const std::string& name, const std::string& from,
                           const std::string& to) {
  std::ifstream page(std::string(ROTATEBOOK_SOURCE) + "/docs/" + name);
  std::string line, rows;
  while (std::getline(page, line) && line != from) continue;
  while (std::getline(page, line) && line != to) {
    if (line.starts_with("| `")) rows += line + "\n";
  }
  return rows;
}

TEST(FuzzDictionary, HasTheWordsOfAScene) {
  const std::string file = std::string(ROTATEBOOK_SOURCE) + "/tests/fuzz/scene.dict";
  std::ifstream stream(file);
  std::set<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.insert(line);
  const auto expectWord = [&](const std::string& word) {
    EXPECT_TRUE(lines.contains('"' + word + '"') || lines.contains("\"\\\"" + word + "\\\"\""))
        << file << " lacks the line \"\\\"" << word << "\\\"\"";
  };
  for (const physics::IntegratorRow& row : physics::integratorTable())
    expectWord(std::string(row.word));
  for (const OverlayRow& row : kOverlayRows) expectWord(std::string(row.name));
  for (const KeyRow& row : allKeys()) expectWord(row.name.substr(row.name.rfind('.') + 1));
}

TEST(KeyRows, AreTheTablesOfTheDocumentation) {
  EXPECT_EQ(documentedRows("tables/keys.md", "# Keys", "# The end"), keyTable())
      << "The rows in docs/tables/keys.md, under as many headings as you like, are to be:\n\n"
      << keyTable();
  EXPECT_EQ(documentedRows("scene.md", "## Expectations", "## Limits"), quantityTable())
      << "The rows in docs/scene.md are to be:\n\n"
      << quantityTable();
}

TEST(KeyRows, AreReadFromTheDocumentation) {
  EXPECT_THAT(documentedRows("tables/keys.md", "# Keys", "# The end"),
              HasSubstr("| `body.mass` | `1.0` |"));
  EXPECT_EQ(documentedRows("scene.md", "## No such heading", "## Limits"), "");
}

TEST(KeyRows, AreInWordsAndEachKeyOnce) {
  std::set<std::string> names;
  for (const KeyRow& row : allKeys()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_FALSE(row.byDefault.empty() || row.byDefault == "``") << row.name;
    EXPECT_FALSE(row.meaning.empty()) << row.name;
    EXPECT_FALSE(row.allowed.empty()) << row.name;
    EXPECT_TRUE(!row.form.dimension || !row.unit.empty()) << row.name;
    EXPECT_TRUE(!row.mayVary || row.affects == Affects::Motion) << row.name;
  }
}

TEST(KeyRows, AreFoundByKeysAndTheirParts) {
  EXPECT_EQ(findKey("initial.tilt.0")->name, "initial.tilt");
  EXPECT_EQ(findKey("nudge.12.angular_momentum.2")->name, "nudge.N.angular_momentum");
  EXPECT_EQ(findKey("title")->name, "title");
  EXPECT_EQ(findKey("initial.tilts"), nullptr);
  EXPECT_EQ(findKey(""), nullptr);
}

TEST(KeyRows, NameAxesWithTheirUnits) {
  EXPECT_EQ(keyWithUnit("body.size.0"), "body.size.0  [m]");
  EXPECT_EQ(keyWithUnit("nudge.0.angular_velocity.1"), "nudge.0.angular_velocity.1  [rad/s]");
  EXPECT_EQ(keyWithUnit("initial.angular_momentum.2"), "initial.angular_momentum.2  [kg m²/s]");
  EXPECT_EQ(keyWithUnit("simulation.stiffness"), "simulation.stiffness  [N/m]");
  EXPECT_EQ(keyWithUnit("simulation.substeps"), "simulation.substeps");
}

TEST(KeyRows, SayWhatChangesNoMotion) {
  using physics::Model;
  const std::vector<Model> rigid{Model::Exact, Model::Quaternion}, exact{Model::Exact},
      particles{Model::Particles};
  EXPECT_EQ(reasonForNoChange("simulation.damping", rigid),
            "simulation.damping is of the model \"particles\" alone");
  EXPECT_EQ(reasonForNoChange("simulation.substeps", exact),
            "simulation.substeps: the model \"exact\" takes no steps");
  EXPECT_EQ(reasonForNoChange("simulation.substeps", rigid), "");
  EXPECT_EQ(reasonForNoChange("body.inertia.0", particles),
            "body.inertia.0: the model \"particles\" doesn't have it");
}

TEST(KeyRows, NameKeysThatAreRead) {
  for (const KeyRow& row : allKeys()) {
    if (row.name.find(".N.") != std::string::npos) continue;  // Of arrays of tables.
    EXPECT_THAT(errorOf("", {row.name + "=1979-05-27"}), HasSubstr(": " + row.name + " "));
  }
}

}  // namespace
}  // namespace rotatebook::scene
