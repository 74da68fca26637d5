// The rooms of the source tree: who may include whom.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
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
  std::string storey;                ///< The folder of src/ that it lies in.
  std::set<std::string> rooms;       ///< Whose headers it may include beside its own.
  std::set<std::string> thirdParty;  ///< Beginnings of the other headers that it may include.
  /// Whose headers those of `rooms` include: the compiler has to find them, but the room itself may
  /// not include them.
  std::set<std::string> through{};
};

// What CONTRIBUTING.md says of the rooms, in the order in which they stand on each other.
const std::map<std::string, Room> kRooms{
    {"base", {"core", {}, {"xxhash.h"}}},
    {"physics", {"core", {"base"}, {"Eigen/"}}},
    {"scene", {"core", {"base", "physics"}, {"Eigen/", "toml++/"}}},
    {"timeline", {"core", {"base", "physics", "scene"}, {"Eigen/"}}},
    {"study", {"core", {"base", "physics", "scene", "timeline"}, {}}},
    {"system", {"platform", {"base"}, {}}},
    {"image", {"platform", {"base", "system"}, {"isa-l.h", "png.h", "zlib.h"}}},
    {"render", {"platform", {"base", "physics", "image"}, {"Eigen/", "epoxy/"}}},
    {"overlay",
     {"platform",
      {"base", "physics", "scene", "system", "image"},
      {"Eigen/", "fontconfig/", "pango/"}}},
    {"video", {"platform", {"base", "system", "image"}, {"libav", "libswscale/"}}},
    {"picture",
     {"app",
      {"base", "physics", "scene", "timeline", "study", "system", "image", "render", "overlay"},
      {"Eigen/"}}},
    {"store",
     {"app",
      {"base", "scene", "timeline", "system", "image", "video", "picture"},
      {},
      {"physics"}}},
    {"pipeline",
     {"app",
      {"base", "scene", "timeline", "system", "image", "render", "video", "picture", "store"},
      {},
      {"physics"}}},
    {"verify",
     {"app",
      {"base", "scene", "timeline", "system", "image", "render", "video", "picture", "store",
       "pipeline"},
      {},
      {"physics"}}},
    {"diagnose",
     {"app",
      {"base", "physics", "scene", "timeline", "study", "system", "image", "render", "overlay",
       "video", "picture", "store", "pipeline"},
      {"Eigen/"}}},
    {"page",
     {"app",
      {"base", "physics", "scene", "timeline", "study", "system", "image", "video", "picture",
       "store", "pipeline"},
      {"Eigen/"}}},
    {"cli",
     {"app",
      {"base", "physics", "scene", "timeline", "study", "system", "image", "render", "overlay",
       "video", "picture", "store", "pipeline", "verify", "diagnose", "page"},
      {"CLI/"}}}};

// Headers of the standard that the core does without, so that it runs in a browser and gives the
// same bits everywhere: operating system, threads, clocks, streams, and what differs between
// standard libraries.
const std::set<std::string> kNotInTheCore{"chrono",    "condition_variable",
                                          "csetjmp",   "csignal",
                                          "cstdio",    "ctime",
                                          "fstream",   "future",
                                          "iostream",  "latch",
                                          "mutex",     "random",
                                          "semaphore", "shared_mutex",
                                          "barrier",   "stop_token",
                                          "thread",    "clocale",
                                          "locale",    "syncstream",
                                          "sstream",   "istream",
                                          "ostream",   "streambuf"};

// Calls by which the standard library reaches files without a stream.
const std::regex kFileCall(
    R"(\b(fs|filesystem)::(exists|is_|file_size|status|canonical|absolute|current_path|remove|rename|)"
    R"(copy|create_|resize_|space|temp_|(recursive_)?directory_iterator|last_write_time|read_symlink)|)"
    R"(\b(getenv|f?open|popen|fork|system)\s*\()");

struct Include {
  std::string room;    ///< Of the file that has it.
  std::string header;  ///< Without its brackets or quotes.
  bool quoted = false;
};

bool startsWithOneOf(const std::string& text, const std::set<std::string>& beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](const std::string& beginning) { return text.starts_with(beginning); });
}

bool isStandard(const std::string& header) {
  return header.find_first_of("./") == std::string::npos;
}

bool isOperatingSystem(const std::string& header) {
  static const std::set<std::string> kHeaders{"unistd.h", "fcntl.h", "grp.h",
                                              "dlfcn.h",  "spawn.h", "sys/"};
  return startsWithOneOf(header, kHeaders);
}

bool isAllowed(const Include& include) {
  const Room& room = kRooms.at(include.room);
  const bool core = room.storey == "core";
  const std::string& header = include.header;
  if (!include.quoted) {
    if (isStandard(header)) return !core || !kNotInTheCore.contains(header);
    if (isOperatingSystem(header)) return !core;
    return startsWithOneOf(header, room.thirdParty);
  }
  const std::string owner = header.substr(0, header.find('/'));
  if (owner == "embedded") return header == "embedded/" + include.room + ".h";
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

/// The room that `file` lies in: src/STOREY/ROOM/...
std::string roomOf(const fs::path& file) {
  return std::next(file.lexically_relative(kSource).begin())->string();
}

TEST(IncludeRules, TellRightFromWrong) {
  EXPECT_TRUE(isAllowed({"physics", "Eigen/Core", false}));
  EXPECT_TRUE(isAllowed({"physics", "vector", false}));
  EXPECT_TRUE(isAllowed({"physics", "physics/cuboid.h", true}));
  EXPECT_TRUE(isAllowed({"system", "thread", false}));
  EXPECT_TRUE(isAllowed({"system", "unistd.h", false}));
  EXPECT_TRUE(isAllowed({"page", "embedded/page.h", true}));
  EXPECT_FALSE(isAllowed({"page", "embedded/render.h", true}));
  EXPECT_FALSE(isAllowed({"physics", "image/image.h", true}));
  EXPECT_FALSE(isAllowed({"physics", "boost/math/constants.hpp", false}));
  EXPECT_FALSE(isAllowed({"image", "epoxy/gl.h", false}));
  EXPECT_FALSE(isAllowed({"base", "Eigen/Core", false}));
  EXPECT_FALSE(isAllowed({"video", "scene/scene.h", true}));
  EXPECT_FALSE(isAllowed({"pipeline", "cli/program.h", true}));
  EXPECT_FALSE(isAllowed({"pipeline", "CLI/CLI.hpp", false}));
  for (const std::string core : {"base", "physics", "scene", "timeline", "study"}) {
    for (const std::string header :
         {"thread", "mutex", "chrono", "ctime", "fstream", "iostream", "cstdio", "random",
          "unistd.h", "fcntl.h", "sys/stat.h", "spawn.h"}) {
      EXPECT_FALSE(isAllowed({core, header, false})) << core << " " << header;
    }
    EXPECT_FALSE(isAllowed({core, "system/atomic_file.h", true})) << core;
  }
}

TEST(IncludeRules, HoldInEveryFile) {
  std::vector<std::string> wrong;
  std::map<std::string, int> seen;
  for (const fs::path& file : filesBelow(kSource)) {
    const std::string room = roomOf(file);
    ASSERT_TRUE(kRooms.contains(room)) << file << " lies in no room";
    EXPECT_EQ(kRooms.at(room).storey, file.lexically_relative(kSource).begin()->string());
    for (const Include& include : includesOf(file, room)) {
      ++seen[room];
      if (!isAllowed(include)) wrong.push_back(file.filename().string() + ": " + include.header);
    }
  }
  EXPECT_THAT(wrong, IsEmpty());
  EXPECT_EQ(seen.size(), kRooms.size());
}

/// The rooms whose headers the compiler finds in the sources of `room`, as CMake wrote them down.
std::set<std::string> roomsSeenBy(const std::string& room) {
  const fs::path roots = ROTATEBOOK_ROOMS;
  std::ifstream stream(roots / (room + ".roots"));
  std::set<std::string> rooms;
  for (std::string line; std::getline(stream, line);) {
    if (fs::path(line).parent_path() == roots) rooms.insert(fs::path(line).filename());
  }
  return rooms;
}

TEST(IncludeRules, TheCompilerFindsTheHeadersOfNoOtherRoom) {
  for (const auto& [name, room] : kRooms) {
    const std::set<std::string> seen = roomsSeenBy(name);
    EXPECT_TRUE(seen.contains(name)) << name;
    for (const std::string& other : seen) {
      EXPECT_TRUE(other == name || room.rooms.contains(other) || room.through.contains(other))
          << name << " sees " << other;
    }
  }
}

std::vector<std::string> fileCallsIn(std::istream& text) {
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) {
    if (std::regex_search(line.substr(0, line.find("//")), kFileCall)) lines.push_back(line);
  }
  return lines;
}

TEST(IncludeRules, TellCallsThatReachFiles) {
  for (const std::string line :
       {"if (fs::exists(path)) return;", "std::filesystem::remove(path);", "getenv(\"HOME\")",
        "fopen(name, \"r\")", "for (auto& e : fs::directory_iterator(folder))"}) {
    std::istringstream text(line);
    EXPECT_THAT(fileCallsIn(text), ElementsAre(line));
  }
  for (const std::string line : {"fs::path folder;", "// fs::exists(path)", "path.stem()",
                                 "reopen (x)", "std::filesystem::path(\"a\") / name"}) {
    std::istringstream text(line);
    EXPECT_THAT(fileCallsIn(text), IsEmpty()) << line;
  }
}

TEST(IncludeRules, TheCoreOpensNoFile) {
  std::size_t seen = 0;
  for (const fs::path& file : filesBelow(kSource / "core")) {
    std::ifstream text(file);
    EXPECT_THAT(fileCallsIn(text), IsEmpty()) << file;
    ++seen;
  }
  EXPECT_GT(seen, 90U);  // measured 109
}

// Eigen alone may show in headers: whoever includes one of ours needs nothing else.
TEST(IncludeRules, ThirdPartyStaysOutOfHeadersOfOtherRooms) {
  std::map<std::string, std::string> leaky;  // room by header
  for (const fs::path& file : filesBelow(kSource)) {
    const std::string room = roomOf(file);
    if (file.extension() != ".h" || room == "cli") continue;
    for (const Include& include : includesOf(file, room)) {
      const std::string& header = include.header;
      if (include.quoted || isStandard(header) || isOperatingSystem(header)) continue;
      if (header.starts_with("Eigen/")) continue;
      leaky[file.lexically_relative(kSource / kRooms.at(room).storey)] = room;
    }
  }
  EXPECT_FALSE(leaky.empty());
  std::set<std::string> leaks;
  for (const fs::path& user : filesBelow(kSource)) {
    const std::string room = roomOf(user);
    for (const Include& used : includesOf(user, room)) {
      const auto found = leaky.find(used.header);
      if (found != leaky.end() && found->second != room) leaks.insert(used.header);
    }
  }
  EXPECT_THAT(leaks, IsEmpty());
}

bool saysInsideOnly(const fs::path& header) {
  std::ifstream stream(header);
  std::string comment;
  for (std::string line; std::getline(stream, line) && line.starts_with("//");) {
    comment += line.substr(2);
  }
  return comment.find("Inside the room only.") != std::string::npos;
}

/// Headers that another room includes than the one they lie in.
std::set<std::string> headersUsedOutside() {
  std::set<std::string> used;
  for (const fs::path& user : filesBelow(kSource)) {
    const std::string room = roomOf(user);
    for (const Include& include : includesOf(user, room)) {
      if (include.quoted && !include.header.starts_with(room + "/")) used.insert(include.header);
    }
  }
  return used;
}

// Headers of the core are for other programs, too.
TEST(IncludeRules, HeadersForTheirRoomAloneSayThat) {
  const std::set<std::string> used = headersUsedOutside();
  std::vector<std::string> silent, wrong;
  for (const fs::path& file : filesBelow(kSource)) {
    if (file.extension() != ".h") continue;
    const std::string& storey = kRooms.at(roomOf(file)).storey;
    const std::string name = file.lexically_relative(kSource / storey);
    const bool inside = saysInsideOnly(file);
    if (inside && used.contains(name)) wrong.push_back(name);
    if (!inside && storey != "core" && !used.contains(name)) silent.push_back(name);
  }
  EXPECT_THAT(wrong, IsEmpty());
  EXPECT_THAT(silent, IsEmpty());
}

}  // namespace
}  // namespace rotatebook
