// The rooms of the source tree: who may include whom.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rotatebook {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

struct Room {
  std::set<std::string> rooms;       ///< Whose headers it may include beside its own.
  std::set<std::string> thirdParty;  ///< Beginnings of the other headers that it may include.
};

const std::map<std::string, Room> kRooms{
    {"base", {{}, {}}},
    {"physics", {{"base"}, {"Eigen/", "boost/"}}},
    {"scene", {{"base", "physics"}, {"Eigen/", "toml++/"}}},
    {"image", {{"base"}, {"isa-l.h", "png.h", "zlib.h"}}},
    {"overlay", {{"base", "physics", "scene", "image"}, {"Eigen/", "fontconfig/", "pango/"}}},
    {"render", {{"base", "image", "physics"}, {"Eigen/", "epoxy/"}}},
    {"video", {{"base", "image"}, {"libav", "libswscale/"}}},
    {"pipeline",
     {{"base", "physics", "scene", "image", "overlay", "render", "video"}, {"Eigen/", "xxhash.h"}}},
    {"page", {{"base", "physics", "scene", "image", "video", "pipeline"}, {"Eigen/"}}},
    {"cli",
     {{"base", "physics", "scene", "image", "overlay", "render", "video", "pipeline", "page"},
      {"CLI/"}}},
};

// What physics does without, so that it runs in a browser and gives the same bits everywhere.
const std::set<std::string> kOperatingSystem{
    "thread", "mutex", "future", "chrono", "fstream", "iostream", "filesystem", "cstdio", "random"};

struct Include {
  std::string room;    ///< Of the file that has it.
  std::string header;  ///< Without its brackets or quotes.
  bool quoted = false;
};

bool startsWithOneOf(const std::string& text, const std::set<std::string>& beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](const std::string& beginning) { return text.starts_with(beginning); });
}

// The standard's headers have neither a folder nor an ending; POSIX's and Linux's have both.
bool isSystem(const std::string& header) {
  static const std::set<std::string> kHeaders{"unistd.h", "fcntl.h", "grp.h",
                                              "dlfcn.h",  "spawn.h", "sys/"};
  return header.find_first_of("./") == std::string::npos || startsWithOneOf(header, kHeaders);
}

bool isAllowed(const Include& include) {
  const Room& room = kRooms.at(include.room);
  if (!include.quoted) {
    if (!isSystem(include.header)) return startsWithOneOf(include.header, room.thirdParty);
    return include.room != "physics" || (!kOperatingSystem.contains(include.header) &&
                                         include.header.find('.') == std::string::npos);
  }
  const std::string owner = include.header.substr(0, include.header.find('/'));
  return owner == include.room || room.rooms.contains(owner);
}

std::vector<Include> includesOf(const fs::path& file, const std::string& room) {
  static const std::regex kInclude(R"(\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
  std::vector<Include> includes;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    std::smatch match;
    if (!std::regex_match(line, match, kInclude)) continue;
    includes.push_back({room, match[2], match[1] == "\""});
  }
  return includes;
}

std::vector<fs::path> filesBelow(const fs::path& folder) {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string extension = entry.path().extension();
    if (extension == ".h" || extension == ".cpp") paths.push_back(entry.path());
  }
  return paths;
}

const fs::path kSource = fs::path(ROTATEBOOK_SOURCE) / "src";

TEST(IncludeRules, TellRightFromWrong) {
  EXPECT_TRUE(isAllowed({"physics", "Eigen/Core", false}));
  EXPECT_TRUE(isAllowed({"physics", "vector", false}));
  EXPECT_TRUE(isAllowed({"physics", "physics/cuboid.h", true}));
  EXPECT_FALSE(isAllowed({"physics", "image/image.h", true}));
  EXPECT_FALSE(isAllowed({"physics", "thread", false}));
  EXPECT_FALSE(isAllowed({"physics", "unistd.h", false}));
  EXPECT_FALSE(isAllowed({"image", "epoxy/gl.h", false}));
  EXPECT_FALSE(isAllowed({"base", "Eigen/Core", false}));
  EXPECT_FALSE(isAllowed({"video", "scene/scene.h", true}));
  EXPECT_FALSE(isAllowed({"pipeline", "cli/program.h", true}));
  EXPECT_FALSE(isAllowed({"pipeline", "CLI/CLI.hpp", false}));
}

TEST(IncludeRules, HoldInEveryFile) {
  std::vector<std::string> wrong;
  std::map<std::string, int> seen;
  for (const fs::path& file : filesBelow(kSource)) {
    const std::string room = file.lexically_relative(kSource).begin()->string();
    ASSERT_TRUE(kRooms.contains(room)) << file << " lies in no room";
    for (const Include& include : includesOf(file, room)) {
      ++seen[room];
      if (!isAllowed(include)) wrong.push_back(file.filename().string() + ": " + include.header);
    }
  }
  EXPECT_THAT(wrong, IsEmpty());
  EXPECT_EQ(seen.size(), kRooms.size());
}

// Eigen alone may show in headers: whoever includes one of ours needs nothing else.
TEST(IncludeRules, ThirdPartyStaysOutOfHeadersOfOtherRooms) {
  std::set<std::string> leaks;
  for (const fs::path& file : filesBelow(kSource)) {
    const std::string room = file.lexically_relative(kSource).begin()->string();
    if (file.extension() != ".h" || room == "cli") continue;
    for (const Include& include : includesOf(file, room)) {
      if (include.quoted || isSystem(include.header) || include.header.starts_with("Eigen/")) {
        continue;
      }
      for (const fs::path& user : filesBelow(kSource)) {
        const std::string userRoom = user.lexically_relative(kSource).begin()->string();
        if (userRoom == room) continue;
        for (const Include& used : includesOf(user, userRoom)) {
          if (used.header == file.lexically_relative(kSource)) leaks.insert(used.header);
        }
      }
    }
  }
  EXPECT_THAT(leaks, IsEmpty());
}

}  // namespace
}  // namespace rotatebook
