#include "store/scene_name.h"

#include <fmt/core.h>

#include "base/text.h"
#include "store/clip_files.h"
#include "store/map_files.h"

namespace rotatebook::store {
namespace {

// Names of files have at most 255 bytes, with endings and temporary prefixes. [bytes]
constexpr std::size_t kMaxName = 200;

}  // namespace

std::string problemOfName(const std::string& name) {
  if (name.empty()) return "is empty";
  if (name.size() > kMaxName)
    return fmt::format("has {} bytes; the limit is {}", name.size(), kMaxName);
  if (!isOneLine(name)) return "isn't a line of UTF-8 without control characters";
  if (name.front() == '.') return "begins with a dot, as names of hidden files do";
  if (name.find('/') != name.npos) return "holds a slash, as paths do";
  for (const char* reserved : {kPartialEnding, kReplacedEnding, kTilesEnding}) {
    if (name.ends_with(reserved))
      return fmt::format("ends in {}, as what a running render writes does", reserved);
  }
  return "";
}

}  // namespace rotatebook::store
