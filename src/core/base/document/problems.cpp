#include "base/document/problems.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <string_view>
#include <utility>

#include "base/text.h"

namespace rotatebook::document {
namespace {

constexpr std::size_t kMaxShown = 20;

/// Returns the line and column of "FILE:LINE:COLUMN"; of overrides, which have none, the greatest.
std::pair<int, int> positionOf(std::string_view location) {
  std::pair<int, int> position{std::numeric_limits<int>::max(), 0};
  if (location.starts_with("--set")) return position;
  const std::size_t column = location.rfind(':');
  const std::size_t line = column == location.npos ? column : location.rfind(':', column - 1);
  if (line == location.npos) return {0, 0};  // the whole file
  std::from_chars(location.data() + line + 1, location.data() + column, position.first);
  std::from_chars(location.data() + column + 1, location.data() + location.size(), position.second);
  return position;
}

std::string messageOf(const std::vector<Problem>& problems) {
  std::vector<std::string> lines;
  for (const Problem& problem : problems) {
    if (lines.size() == kMaxShown) break;
    lines.push_back(problem.location + ": " + problem.text + problem.remedy);
  }
  const std::size_t others = problems.size() - lines.size();
  if (others > 0) lines.push_back("and " + std::to_string(others) + " more");
  return joined(lines, kNextLine);
}

}  // namespace

DocumentError::DocumentError(std::vector<Problem> all)
    : InputError(messageOf(all)), problems_(std::move(all)) {}

void Problems::throwIfAny() {
  if (noted_.empty()) return;
  const auto position = [](const Problem& problem) {
    return std::pair(positionOf(problem.location), std::string_view(problem.location));
  };
  std::ranges::stable_sort(noted_, {}, position);
  // A panel repeats the problems of what it takes from the scene.
  const auto isSame = [](const Problem& one, const Problem& other) {
    return one.location == other.location;
  };
  const auto repeated = std::unique(noted_.begin(), noted_.end(), isSame);
  noted_.erase(repeated, noted_.end());
  throw DocumentError(noted_);
}

}  // namespace rotatebook::document
