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

/// Returns what the header has players cut off the pictures (PixelCropLeft and so on): "none", or
/// for example "2 pixels at the left"; "unknown" if `file`, which may be anything, has no header.
std::string webmCropText(std::istream& file);

}  // namespace rotatebook::video
