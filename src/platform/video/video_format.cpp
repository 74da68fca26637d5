#include "video/video_format.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "base/error.h"
#include "base/nearest_name.h"
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

VideoFormat formatOfFile(const std::filesystem::path& file, std::string_view otherwise) {
  if (const auto format = formatOfName(file.filename().string())) return *format;
  const std::string ending = file.extension().string();
  std::vector<std::string_view> endings;
  for (const FormatRow& row : kFormatRows) {
    if (lowerCase(ending) == row.ending) {
      throw InputError(
          fmt::format("{}: videos end in small letters; write {}", file.string(),
                      std::filesystem::path(file).replace_extension(row.ending).string()));
    }
    endings.push_back(row.ending);
  }
  const std::string problem =
      ending.empty() ? "a video's name needs an ending" : "no video ends in " + quotedText(ending);
  throw InputError(fmt::format("{}: {}; there are {}{}{}", file.string(), problem,
                               quotedList(endings, "and"), otherwise, didYouMean(ending, endings)));
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
