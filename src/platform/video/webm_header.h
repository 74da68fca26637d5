// Elements of a WebM, and instructions to players in its header that FFmpeg doesn't report. Inside
// the room only.
#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string>

namespace rotatebook::video {

/// Reads the length of an element's content; nothing if it isn't stated. [bytes]
std::optional<std::uint64_t> webmLengthIn(std::istream& file);

/// Instructions to players in a WebM's header.
struct WebmHeader {
  /// Pixels to cut off (PixelCropLeft and so on): "none", for example "2 pixels at the left", or
  /// "unknown".
  std::string crop = "unknown";
  bool interlaced = false;  ///< As FlagInterlaced says.
};

/// Reads `file`, which may be anything. The crop is unknown if it has more elements than any clip.
WebmHeader readWebmHeader(std::istream& file);

}  // namespace rotatebook::video
