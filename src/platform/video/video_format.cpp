#include "video/video_format.h"

#include <vector>

namespace rotatebook::video {

std::string demuxers() {
  std::string names;
  for (const FormatRow& row : kFormatRows) {
    names += (names.empty() ? "" : ",") + std::string(row.demuxer);
  }
  return names;
}

std::string decoders() {
  std::string names;
  for (const FormatRow& row : kFormatRows) {
    if (!row.holdsRecord) continue;
    names += (names.empty() ? "" : ",") + std::string(row.recorded.decoders);
  }
  return names;
}

std::string listFormats(std::string_view FormatRow::*column, std::string_view conjunction,
                        bool FormatRow::*property) {
  std::vector<std::string_view> listed;
  for (const FormatRow& row : kFormatRows) {
    if (property == nullptr || row.*property) listed.push_back(row.*column);
  }
  std::string text;
  for (std::size_t i = 0; i < listed.size(); ++i) {
    if (i > 0) text += i + 1 < listed.size() ? ", " : " " + std::string(conjunction) + " ";
    text += listed[i];
  }
  return text;
}

}  // namespace rotatebook::video
