#include "cli/live_follower.h"

#include <cstdint>
#include <string_view>
#include <system_error>

#include <fmt/core.h>

#include "base/error.h"
#include "base/text.h"
#include "cli/input_guard.h"
#include "cli/installed_file.h"
#include "embedded/cli.h"
#include "picture/named_file.h"
#include "scene/scene_text.h"
#include "system/atomic_file.h"
#include "system/read_file.h"

namespace rotatebook::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLongestBook = 1 << 24;
constexpr std::uintmax_t kLongestNamed = 1'000'000;  // As kLargestThing of the live book.
constexpr std::string_view kPageBegins = "<!-- Made by rotatebook watch. -->\n";
constexpr std::string_view kScriptBegins = "// Made by rotatebook watch.\n";

std::string readBook(const fs::path& book) {
  std::string page = system::readFileOrEmpty(book, kLongestBook);
  if (page.starts_with("<!doctype html>") && page.find("\"rb-live\"") != std::string::npos)
    return page;
  throw InputError(fmt::format("--live {}: {} the live book; name play.html, which make play makes",
                               oneLine(book.string()),
                               fs::exists(book) ? "it isn't" : "there is no file of"));
}

/// Returns bytes as letters of the same numbers, in UTF-8, as texts in JSON are.
std::string lettersOf(std::string_view bytes) {
  std::string letters;
  for (const char letter : bytes) {
    const auto byte = static_cast<unsigned char>(letter);
    if (byte < 0x80) {
      letters += letter;
    } else {
      letters += static_cast<char>(0xc0 | byte >> 6);
      letters += static_cast<char>(0x80 | (byte & 0x3f));
    }
  }
  return letters;
}

/// Returns the files that a motion follows from, by the names that the scene has for them.
Json filesOf(const scene::Scene& scene, const fs::path& folder) {
  Json files = Json::array();
  for (const picture::NamedFile& file : picture::namedFiles(scene)) {
    if (file.kind != "mesh" && file.kind != "recording") continue;
    files.push_back({{"name", file.path.lexically_relative(folder).string()},
                     {"letters", lettersOf(system::readInput(file.path, kLongestNamed))}});
  }
  return files;
}

}  // namespace

fs::path installedBook() {
  if (const auto installed = installedFile("play.html")) return *installed;
  const fs::path made = programPrefix() / "play/play.html";  // Beside build/release.
  std::error_code error;
  if (fs::exists(made, error)) return made;
  throw InputError(
      "--live: no live book is installed with the program; name play.html, which make play makes: "
      "--live PLAY.html");
}

LiveFollower::LiveFollower(const fs::path& book, const fs::path& folder, const std::string& name)
    : page_(folder / (name + ".live.html")), script_(folder / (name + ".live.js")) {
  const std::string live = readBook(book);
  requireAbsentOr(page_, kPageBegins);
  requireAbsentOr(script_, kScriptBegins);
  system::writeFileAtomically(
      page_, fmt::format("{}{}<script>\n{}follow({});\n</script>\n", kPageBegins, live,
                         followScript(), jsonText(script_.filename().string())));
}

void LiveFollower::play(const scene::Scene& scene, const fs::path& file) const {
  write({{"text", scene::briefText(scene)}, {"files", filesOf(scene, file.parent_path())}});
}

void LiveFollower::say(const std::string& message) const {
  write({{"problem", message}});
}

void LiveFollower::write(const Json& content) const {
  system::writeFileAtomically(
      script_, fmt::format("{}rotatebookFollows({});\n", kScriptBegins, jsonText(content)));
}

}  // namespace rotatebook::cli
