#include "video/video_format.h"

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

std::string demuxers() {
  return joined(columnOf(&FormatRow::demuxer, nullptr), ",");
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
