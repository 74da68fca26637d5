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

#include "house/source_tree.h"

namespace rotatebook::house {
namespace {

namespace fs = std::filesystem;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

struct Room {
  std::string storey;                ///< The folder of src/ that it lies in.
  std::set<std::string> rooms;       ///< Whose headers it may include beside its own.
  std::set<std::string> thirdParty;  ///< Beginnings of the other headers that it may include.
  /// Whose headers those of `rooms` include: the compiler has to find them, but the room itself may
  /// not include them.
  std::set<std::string> through{};
};

// The rooms as CONTRIBUTING.md lists them, each after those that it is built on.
const std::map<std::string, Room> kRooms{
    {"base", {"core", {}, {"nlohmann/", "toml++/", "xxhash.h"}}},
    {"rigid", {"core", {"base"}, {"Eigen/"}}},
    {"body", {"core", {"base"}, {"Eigen/"}}},
    {"meshes", {"core", {"base", "body"}, {"Eigen/", "nlohmann/"}}},
    {"recording", {"core", {"base", "rigid"}, {"Eigen/"}}},
    {"physics", {"core", {"base", "rigid", "body", "recording"}, {"Eigen/"}}},
    {"geometry", {"core", {"base", "body"}, {"Eigen/"}}},
    {"scene", {"core", {"base", "rigid", "recording", "body", "meshes", "physics"}, {"Eigen/"}}},
    {"timeline",
     {"core",
      {"base", "rigid", "recording", "physics", "geometry", "scene"},
      {"Eigen/"},
      {"body"}}},
    {"study", {"core", {"base", "rigid", "physics", "scene", "timeline"}, {"Eigen/"}, {"body"}}},
    {"bridge",
     {"browser",
      {"base", "recording", "geometry", "scene", "timeline"},
      {"Eigen/"},
      {"rigid", "body", "physics"}}},
    {"system", {"platform", {"base"}, {"zip.h"}}},
    {"image",
     {"platform",
      {"base", "system"},
      {"isa-l.h", "jerror.h", "jpeglib.h", "png.h", "webp/", "zlib.h"}}},
    {"render",
     {"platform", {"base", "body", "geometry", "image"}, {"Eigen/", "epoxy/"}, {"rigid"}}},
    {"overlay",
     {"platform",
      {"base", "rigid", "physics", "scene", "system", "image"},
      {"Eigen/", "fontconfig/", "pango/"},
      {"body"}}},
    {"video", {"platform", {"base", "system", "image"}, {"libav", "libswscale/"}}},
    {"plot",
     {"app",
      {"base", "scene", "study", "image", "overlay"},
      {"Eigen/", "cairo"},
      {"rigid", "body", "physics", "timeline"}}},
    {"picture",
     {"app",
      {"base", "body", "physics", "geometry", "scene", "timeline", "system", "image", "render",
       "overlay", "plot"},
      {"Eigen/"},
      {"rigid"}}},
    {"store",
     {"app",
      {"base", "scene", "timeline", "study", "system", "video", "picture"},
      {},
      {"rigid", "body", "physics", "geometry", "image"}}},
    {"farm",
     {"app",
      {"base", "system", "store"},
      {},
      {"rigid", "body", "physics", "geometry", "scene", "timeline", "video"}}},
    {"pipeline",
     {"app",
      {"base", "scene", "timeline", "study", "system", "image", "video", "plot", "picture",
       "store"},
      {},
      {"rigid", "body", "physics", "geometry", "render"}}},
    {"diagnose",
     {"app",
      {"base", "body", "system", "image", "render", "overlay", "video"},
      {"Eigen/"},
      {"rigid", "physics", "geometry", "scene"}}},
    {"page",
     {"app",
      {"base", "scene", "timeline", "system", "image", "video", "store"},
      {"Eigen/", "zip.h"},
      {"rigid", "body", "physics", "geometry"}}},
    {"cli",
     {"app",
      {"base", "recording", "physics", "scene", "timeline", "study", "system", "image", "video",
       "plot", "picture", "store", "farm", "pipeline", "diagnose", "page"},
      {"CLI/", "Eigen/", "glib.h", "zip.h"},
      {"rigid", "body", "geometry", "render"}}}};

// Headers of the standard that the core may include, so that it runs in a browser and gives the
// same bits everywhere: without operating system, threads, clocks, streams, and what differs
// between standard libraries. Of <filesystem> it takes the path alone, see core_calls_test.cpp.
const std::set<std::string> kStandardInTheCore{
    "algorithm",   "array",      "atomic",           "bit",         "charconv",     "cmath",
    "compare",     "concepts",   "cstddef",          "cstdint",     "cstring",      "exception",
    "filesystem",  "functional", "initializer_list", "iterator",    "limits",       "map",
    "memory",      "new",        "numbers",          "numeric",     "optional",     "set",
    "span",        "stdexcept",  "string",           "string_view", "system_error", "tuple",
    "type_traits", "utility",    "variant",          "vector"};

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
  static const std::set<std::string> kHeaders{"unistd.h", "fcntl.h",    "grp.h",   "pwd.h",
                                              "dlfcn.h",  "link.h",     "sched.h", "spawn.h",
                                              "sys/",     "execinfo.h", "poll.h"};
  return startsWithOneOf(header, kHeaders);
}

bool isAllowed(const Include& include) {
  const Room& room = kRooms.at(include.room);
  const bool core = room.storey == "core";
  const std::string& header = include.header;
  if (!include.quoted) {
    if (isStandard(header)) return !core || kStandardInTheCore.contains(header);
    if (isOperatingSystem(header)) return !core;
    if (header == "fmt/core.h" || header == "fmt/ostream.h")
      return room.storey == "platform" || room.storey == "app";
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

/// The room that `file` lies in: src/STOREY/ROOM/...
std::string roomOf(const fs::path& file) {
  return std::next(file.lexically_relative(kSource).begin())->string();
}

TEST(IncludeRules, DistinguishRightFromWrong) {
  EXPECT_TRUE(isAllowed({"physics", "Eigen/Core", false}));
  EXPECT_TRUE(isAllowed({"physics", "vector", false}));
  EXPECT_TRUE(isAllowed({"physics", "body/cuboid.h", true}));
  EXPECT_TRUE(isAllowed({"system", "thread", false}));
  EXPECT_TRUE(isAllowed({"system", "unistd.h", false}));
  EXPECT_TRUE(isAllowed({"page", "embedded/page.h", true}));
  EXPECT_TRUE(isAllowed({"image", "fmt/core.h", false}));
  EXPECT_TRUE(isAllowed({"store", "fmt/core.h", false}));
  EXPECT_FALSE(isAllowed({"page", "embedded/render.h", true}));
  EXPECT_FALSE(isAllowed({"physics", "image/image.h", true}));
  EXPECT_FALSE(isAllowed({"physics", "boost/math/constants.hpp", false}));
  EXPECT_FALSE(isAllowed({"image", "epoxy/gl.h", false}));
  EXPECT_FALSE(isAllowed({"scene", "fmt/core.h", false}));
  EXPECT_FALSE(isAllowed({"bridge", "fmt/core.h", false}));
  EXPECT_FALSE(isAllowed({"image", "fmt/format.h", false}));
  EXPECT_FALSE(isAllowed({"base", "Eigen/Core", false}));
  EXPECT_FALSE(isAllowed({"video", "scene/scene.h", true}));
  EXPECT_FALSE(isAllowed({"pipeline", "cli/program.h", true}));
  EXPECT_FALSE(isAllowed({"pipeline", "CLI/CLI.hpp", false}));
  for (const std::string core : {"base", "rigid", "body", "meshes", "recording", "physics",
                                 "geometry", "scene", "timeline", "study"}) {
    for (const std::string header :
         {"thread",   "mutex",         "chrono",     "ctime",   "fstream",   "iostream",
          "cstdio",   "random",        "complex",    "cstdlib", "execution", "iomanip",
          "sstream",  "unordered_map", "math.h",     "stdio.h", "time.h",    "pthread.h",
          "unistd.h", "fcntl.h",       "sys/stat.h", "spawn.h"}) {
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

// It takes the mesh of any body.
TEST(IncludeRules, AntialiasingKnowsNoBook) {
  std::size_t seen = 0;
  for (const fs::path& file : filesBelow(kSource / "platform/render/antialias")) {
    for (const Include& include : includesOf(file, "render")) {
      EXPECT_FALSE(include.header.starts_with("render/body/")) << file << ": " << include.header;
      ++seen;
    }
  }
  EXPECT_GT(seen, 40U);  // measured 60
}

// Eigen alone may show in headers, and nlohmann's JSON in that of base: whoever includes another of
// ours needs nothing else.
const std::string kJsonHeader = "base/json.h";

TEST(IncludeRules, ThirdPartyStaysOutOfHeadersOfOtherRooms) {
  std::map<std::string, std::string> leaky;  // room by header
  for (const fs::path& file : filesBelow(kSource)) {
    const std::string room = roomOf(file);
    if (file.extension() != ".h" || room == "cli") continue;
    for (const Include& include : includesOf(file, room)) {
      const std::string& header = include.header;
      if (include.quoted || isStandard(header) || isOperatingSystem(header)) continue;
      const std::string name = file.lexically_relative(kSource / kRooms.at(room).storey);
      if (header.starts_with("Eigen/") || name == kJsonHeader) continue;
      leaky[name] = room;
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

/// Headers that another room includes than the one they lie in, or a program of examples/.
std::set<std::string> headersUsedOutside() {
  std::set<std::string> used;
  const auto look = [&used](const fs::path& user, const std::string& room) {
    for (const Include& include : includesOf(user, room)) {
      if (include.quoted && !include.header.starts_with(room + "/")) used.insert(include.header);
    }
  };
  for (const fs::path& user : filesBelow(kSource)) look(user, roomOf(user));
  for (const fs::path& user : filesBelow(kSource.parent_path() / "examples")) look(user, "");
  return used;
}

/// Headers of the core that are installed: those that are used outside, those that they include,
/// and so on.
std::set<std::string> publicHeadersOfTheCore() {
  std::set<std::string> headers = headersUsedOutside();
  std::erase_if(headers, [](const auto& name) { return !fs::exists(kSource / "core" / name); });
  std::vector<std::string> left(headers.begin(), headers.end());
  while (!left.empty()) {
    const fs::path header = kSource / "core" / left.back();
    left.pop_back();
    for (const Include& include : includesOf(header, "")) {
      if (include.quoted && headers.insert(include.header).second) left.push_back(include.header);
    }
  }
  return headers;
}

// Those of the core that say it aren't installed; so no header that is installed may include them.
TEST(IncludeRules, HeadersForTheirRoomAloneSayThat) {
  std::set<std::string> used = headersUsedOutside();
  used.insert("bridge/bridge.h");  // by pages
  const std::set<std::string> ofCore = publicHeadersOfTheCore();
  std::vector<std::string> silent, wrong;
  for (const fs::path& file : filesBelow(kSource)) {
    if (file.extension() != ".h") continue;
    const std::string& storey = kRooms.at(roomOf(file)).storey;
    const std::string name = file.lexically_relative(kSource / storey);
    const bool isPublic = (storey == "core" ? ofCore : used).contains(name);
    if (saysInsideOnly(file) == isPublic) (isPublic ? wrong : silent).push_back(name);
  }
  EXPECT_THAT(wrong, IsEmpty());
  EXPECT_THAT(silent, IsEmpty());
}

TEST(IncludeRules, HeadersThatOthersIncludeArePublicWithWhatTheyInclude) {
  const std::set<std::string> headers = publicHeadersOfTheCore();
  EXPECT_TRUE(headers.contains("scene/scene_text.h"));  // A program includes it.
  EXPECT_TRUE(headers.contains("rigid/polhode.h"));     // exact_motion.h includes it.
  EXPECT_FALSE(headers.contains("physics/integrators/verlet.h"));
  EXPECT_FALSE(headers.contains("base/document/toml_parser.h"));
  EXPECT_TRUE(saysInsideOnly(kSource / "core/physics/integrators/splitting.h"));  // In two lines.
  EXPECT_FALSE(saysInsideOnly(kSource / "core/scene/scene_text.h"));
}

// The installed package asks for Eigen alone, and results as JSON for nlohmann's.
TEST(IncludeRules, PublicHeadersOfTheCoreNeedEigenAlone) {
  std::set<std::string> withJson;
  for (const std::string& header : publicHeadersOfTheCore()) {
    for (const Include& include : includesOf(kSource / "core" / header, "base")) {
      if (include.header == kJsonHeader) withJson.insert(header);
      const bool known = include.quoted || isStandard(include.header) || header == kJsonHeader;
      EXPECT_TRUE(known || include.header.starts_with("Eigen/"))
          << header << ": " << include.header;
    }
  }
  EXPECT_THAT(withJson, UnorderedElementsAre("study/bounds_json.h", "study/map_files.h",
                                             "timeline/clip_json.h"));
}

}  // namespace
}  // namespace rotatebook::house
