#include "page/pack_mark.h"

#include <sstream>

#include <fmt/core.h>

namespace rotatebook::page {
namespace {

constexpr std::string_view kPackHead =
    "rotatebook pack 1\n"
    "# A page for the web, by rotatebook page --pack, which replaces these files and no others:\n"
    "# checksum, checksum of what it is made from, name.\n";
constexpr std::string_view kNoSource = "-";

}  // namespace

std::string packMarkText(const PackFiles& files) {
  std::string text(kPackHead);
  for (const auto& [name, states] : files) {
    for (const auto& [checksum, source] : states)
      text += fmt::format("{} {} {}\n", checksum, source.empty() ? kNoSource : source, name);
  }
  return text;
}

std::optional<PackFiles> parsePackMark(std::string_view text) {
  if (!text.starts_with(kPackHead)) return std::nullopt;
  std::istringstream lines{std::string(text.substr(kPackHead.size()))};
  PackFiles files;
  std::string checksum, source, name;
  while (lines >> checksum >> source && lines.get() == ' ' && std::getline(lines, name))
    files[name][checksum] = source == kNoSource ? "" : source;
  return files;
}

}  // namespace rotatebook::page
