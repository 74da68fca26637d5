// Instructions to players in an MP4's header that FFmpeg doesn't report. Inside the room only.
#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rotatebook::video {

/// A box of an MP4; `end` may lie beyond the file's.
struct Mp4Box {
  std::string type;           ///< "moov"
  std::uint64_t content = 0;  ///< Offset of its content. [bytes]
  std::uint64_t end = 0;      ///< Offset of its end. [bytes]
};

/// Returns the box at offset `at` of a box or file that ends at offset `end`; nothing if there is
/// none.
std::optional<Mp4Box> mp4BoxAt(std::istream& file, std::uint64_t at, std::uint64_t end);

/// Size and speed at which players show the first track.
struct Mp4Header {
  /// A part of the time line that is played.
  struct Edit {
    double duration = 0;  ///< [s]
    double speed = 0;     ///< 1: as recorded.
  };

  double shownWidth = 0;      ///< [pixels]
  double shownHeight = 0;     ///< [pixels]
  double speed = 0;           ///< Of the whole; 1: as recorded.
  std::vector<Edit> edits{};  ///< The first 16.
  /// "none", "clean aperture" if that has players cut off margins, or "unknown".
  std::string crop = "unknown";
};

/// Reads `file`, which may be anything; fields that it lacks are 0. So are all if it has more boxes
/// than any clip, or two of a type that may be there once.
Mp4Header readMp4Header(std::istream& file);

}  // namespace rotatebook::video
