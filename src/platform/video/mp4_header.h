// What an MP4's header has players do, where FFmpeg doesn't tell. Inside the room only.
#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rotatebook::video {

/// A part of an MP4; `end` may lie beyond the file's.
struct Mp4Box {
  std::string type;           ///< "moov"
  std::uint64_t content = 0;  ///< Where what it holds begins. [bytes]
  std::uint64_t end = 0;      ///< [bytes]
};

/// The box at byte `at`, in what ends at byte `end`; nothing where there is none.
std::optional<Mp4Box> mp4BoxAt(std::istream& file, std::uint64_t at, std::uint64_t end);

/// How the first track is shown, and how fast.
struct Mp4Header {
  /// A stretch of time that is played.
  struct Edit {
    double duration = 0;  ///< [s]
    double speed = 0;     ///< 1 as it was recorded.
  };

  double shownWidth = 0;      ///< [pixels]
  double shownHeight = 0;     ///< [pixels]
  double speed = 0;           ///< Of the whole; 1 as it was recorded.
  std::vector<Edit> edits{};  ///< The first 16.
};

/// Reads `file`, be it what it may; what it lacks is 0.
Mp4Header readMp4Header(std::istream& file);

}  // namespace rotatebook::video
