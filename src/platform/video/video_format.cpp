#include "video/video_format.h"

#include <algorithm>
#include <string>
#include <vector>

#include "base/text.h"

namespace rotatebook::video {
namespace {

/// Returns a column of those rows that have `property`; of all, if that is null.
std::vector<std::string> columnOf(std::string_view FormatRow::*column, bool FormatRow::*property) {
  std::vector<std::string> cells;
  for (const FormatRow& row : kFormatRows) {
    if (property == nullptr || row.*property) cells.emplace_back(row.*column);
  }
  return cells;
}

}  // namespace

std::optional<VideoFormat> formatOfName(std::string_view fileName) {
  const FormatRow* found = nullptr;
  for (const FormatRow& row : kFormatRows) {
    const bool isLonger = found == nullptr || row.ending.size() > found->ending.size();
    if (fileName.ends_with(row.ending) && isLonger) found = &row;
  }
  return found == nullptr ? std::nullopt : std::optional(found->format);
}

std::string demuxers() {
  std::vector<std::string> names;
  for (const FormatRow& row : kFormatRows) {
    if (std::ranges::count(names, row.demuxer) == 0) names.emplace_back(row.demuxer);
  }
  return joined(names, ",");
}

std::string decoders() {
  std::vector<std::string> names;
  for (const FormatRow& row : kFormatRows) {
    if (row.holdsRecord) names.emplace_back(row.recorded.decoders);
  }
  return joined(names, ",");
}

std::string listFormats(std::string_view FormatRow::*column, std::string_view conjunction,
                        bool FormatRow::*property) {
  return listed(columnOf(column, property), conjunction);
}

}  // namespace rotatebook::video
