// The documentation's links, the files that it names, and the length of its lines.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>
#include <set>
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

const fs::path kRoot = ROTATEBOOK_SOURCE;

constexpr std::size_t kMaxLines = 150;
constexpr std::size_t kMaxColumns = 120;

/// Pages whose tables have long cells, which Markdown can't break.
const std::set<std::string> kWideTables{
    "CONTRIBUTING.md", "docs/bodies.md",      "docs/panels-and-overlays.md", "docs/paper.md",
    "docs/scene.md",   "docs/tables/keys.md", "docs/tables/reliability.md",  "docs/teachers.md",
    "docs/vary.md"};

/// The name by which a link reaches a heading: small letters, digits, hyphens for spaces.
std::string anchorOf(const std::string& heading) {
  std::string anchor;
  for (const unsigned char c : heading) {
    if (c == ' ') anchor += '-';
    if (std::isalnum(c) || c == '-' || c == '_' || c >= 0x80) {
      anchor += static_cast<char>(std::tolower(c));
    }
  }
  return anchor;
}

std::set<std::string> anchorsIn(const std::string& page) {
  static const std::regex kHeading("#+ (.*)");
  std::set<std::string> anchors;
  bool isInside = false;
  for (const std::string& line : linesOf(page)) {
    if (line.starts_with("```")) isInside = !isInside;
    std::smatch heading;
    if (!isInside && std::regex_match(line, heading, kHeading)) {
      anchors.insert(anchorOf(heading[1]));
    }
  }
  return anchors;
}

/// Returns the targets of the page's links, as they are written, without those on other sites.
std::vector<std::string> linksIn(const std::string& page) {
  static const std::regex kLink(R"(\]\(([^)\s]+)\))");
  std::vector<std::string> links;
  for (const std::string& line : proseOf(page)) {
    for (std::sregex_iterator it(line.begin(), line.end(), kLink), end; it != end; ++it) {
      if (const std::string link = (*it)[1]; !link.starts_with("http")) links.push_back(link);
    }
  }
  return links;
}

/// The file, relative to the root, that a link on the page `name` leads to.
std::string fileOf(const std::string& link, const std::string& name) {
  const std::string file = link.substr(0, link.find('#'));
  if (file.empty()) return name;
  return (fs::path(name).parent_path() / file).lexically_normal().string();
}

bool leadsSomewhere(const std::string& link, const std::string& name) {
  const std::string file = fileOf(link, name);
  if (!fs::exists(kRoot / file)) return false;
  const std::size_t hash = link.find('#');
  if (hash == std::string::npos) return true;
  return anchorsIn(readText(kRoot / file)).contains(link.substr(hash + 1));
}

/// Files that pages name but commands write, or readers.
const std::set<std::string> kNotShipped{"diff.png", "my.toml", "scene.toml"};

/// Returns the files and folders of the repository, each as "/PATH".
std::vector<std::string> shippedPaths() {
  std::vector<std::string> paths;
  for (const char* top : {"assets", "bench", "cmake", "docs", "examples", "python", "scenes",
                          "scripts", "shaders", "src", "tests"}) {
    paths.push_back(std::string("/") + top);
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / top)) {
      paths.push_back('/' + entry.path().lexically_relative(kRoot).string());
    }
  }
  return paths;
}

/// Returns whether a text between backticks names a file or folder of the repository: it ends in a
/// slash or as sources do, or begins with one of the folders. NAME and the like are placeholders.
bool namesShippedFile(const std::string& span) {
  static const std::regex kName(
      R"((assets|bench|cmake|docs|examples|python|scenes|scripts|shaders|src|tests)/[\w./-]+|)"
      R"([\w./-]+(/|\.(c?js|cpp|frag|h|html|inc|md|png|py|sh|svg|toml|txt|vert|webp)))");
  static const std::regex kPlaceholder(R"((.*/)?[A-Z]{4,}([/_.-].*)?)");
  static const std::regex kMade("(out|build)/.*|/.*");
  return std::regex_match(span, kName) && !std::regex_match(span, kMade) &&
         (!std::regex_match(span, kPlaceholder) || span.ends_with("README.md")) &&
         !kNotShipped.contains(span);
}

/// Returns the files that the page names and the repository lacks. A name may leave out folders.
std::vector<std::string> missingFilesIn(const std::string& page) {
  static const std::vector<std::string> kPaths = shippedPaths();
  std::vector<std::string> missing;
  for (const std::string& span : codeSpansOf(page)) {
    if (!namesShippedFile(span)) continue;
    const std::string ending = '/' + span.substr(0, span.find_last_not_of('/') + 1);
    const bool isThere = std::any_of(kPaths.begin(), kPaths.end(), [&](const std::string& path) {
      return path.ends_with(ending);
    });
    if (!isThere) missing.push_back(span);
  }
  return missing;
}

std::size_t columnsOf(const std::string& line) {
  return static_cast<std::size_t>(
      std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/// The lines that are too long, apart from what programs print and from the tables that may be.
std::vector<std::string> longLinesIn(const std::string& page, bool mayHaveWideTables) {
  std::vector<std::string> longLines;
  bool isOutput = false;
  for (const std::string& line : linesOf(page)) {
    if (line.starts_with("```")) isOutput = line == "```text";
    const bool mayBeLong = isOutput || (mayHaveWideTables && line.starts_with('|'));
    if (!mayBeLong && columnsOf(line) > kMaxColumns) longLines.push_back(line);
  }
  return longLines;
}

TEST(DocumentationLinks, AreRead) {
  EXPECT_EQ(anchorOf("`[clip]` and `[video]`"), "clip-and-video");
  EXPECT_THAT(anchorsIn("# What is replaced, and what stays\n```sh\n# no heading\n```\n"),
              ElementsAre("what-is-replaced-and-what-stays"));
  EXPECT_THAT(linksIn("[a](b.md#c), `[d](e)`\n```text\n[f](g)\n```\n[h](https://i)\n"),
              ElementsAre("b.md#c"));
  EXPECT_EQ(fileOf("../README.md#a", "docs/scene.md"), "README.md");
  EXPECT_EQ(fileOf("#a", "docs/scene.md"), "docs/scene.md");
}

TEST(DocumentationLinks, AreNoticedWhereTheyLeadNowhere) {
  EXPECT_TRUE(leadsSomewhere("docs/scene.md#limits", "README.md"));
  EXPECT_FALSE(leadsSomewhere("docs/scene.md#no-such-heading", "README.md"));
  EXPECT_FALSE(leadsSomewhere("docs/no-such-page.md", "README.md"));
  EXPECT_FALSE(leadsSomewhere("docs/scene.md", "docs/scene.md"));
}

TEST(DocumentationLinks, LeadToFilesAndHeadingsThatThereAre) {
  std::vector<std::string> broken;
  for (const std::string& name : documentationPages()) {
    for (const std::string& link : linksIn(readText(kRoot / name))) {
      if (!leadsSomewhere(link, name)) broken.push_back(name + ": " + link);
    }
  }
  EXPECT_THAT(broken, IsEmpty());
}

TEST(DocumentationLinks, ReachEveryPageFromTheReadme) {
  std::set<std::string> reached{"README.md"};
  std::vector<std::string> next{"README.md"};
  while (!next.empty()) {
    const std::string name = next.back();
    next.pop_back();
    for (const std::string& link : linksIn(readText(kRoot / name))) {
      const std::string file = fileOf(link, name);
      if (file.ends_with(".md") && reached.insert(file).second) next.push_back(file);
    }
  }
  std::vector<std::string> missed;
  for (const std::string& name : documentationPages()) {
    if (!reached.contains(name)) missed.push_back(name);
  }
  EXPECT_THAT(missed, IsEmpty());
}

TEST(DocumentationFiles, AreNoticedWhereThereAreNone) {
  EXPECT_THAT(missingFilesIn("`no_such_test.cpp`, `tests/no_such_folder`, `no_such/`\n"
                             "```sh\nrotatebook check `no_such.h`\n```\n"
                             "`scene/no_such.h`, `test_frame.png`"),
              ElementsAre("no_such_test.cpp", "tests/no_such_folder", "no_such/", "scene/no_such.h",
                          "test_frame.png"));
  EXPECT_THAT(missingFilesIn("`reference_picture.png`, `scene/scene.h`, `measure/`, `docs/page.md`,"
                             "`NAME.png`, `NAME/scene.toml`, `out/index.html`, `body.inertia`,"
                             "`src/core`, `tests/fuzz/NAME_target.cpp`, `assets/README.md`"),
              IsEmpty());
}

TEST(DocumentationFiles, AreThere) {
  for (const std::string& name : documentationPages()) {
    EXPECT_THAT(missingFilesIn(readText(kRoot / name)), IsEmpty()) << name;
  }
}

TEST(DocumentationLines, AreShortEnough) {
  EXPECT_THAT(
      longLinesIn(std::string(121, 'x') + "\n```text\n" + std::string(121, 'y') + "\n```\n", false),
      ElementsAre(std::string(121, 'x')));
  for (const std::string& name : documentationPages()) {
    EXPECT_THAT(longLinesIn(readText(kRoot / name), kWideTables.contains(name)), IsEmpty()) << name;
  }
  EXPECT_LE(linesOf(readText(kRoot / "README.md")).size(), kMaxLines);  // measured 101
}

}  // namespace
}  // namespace rotatebook::house
