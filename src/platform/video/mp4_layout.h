// The boxes of an MP4 as the program's own muxer writes them. Inside the room only.
#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string>

#include "video/clip_form.h"
#include "video/layout.h"

namespace rotatebook::video {

/// Returns the box at offset `at` of a box or file that ends at offset `end`; nothing if there is
/// none.
std::optional<Part> mp4BoxAt(std::istream& file, std::uint64_t at, std::uint64_t end);

/// Returns the first difference of the MP4 `file`, which may be anything, from what the muxer
/// writes for `form` and the packets of `payload`; empty if there is none.
std::string mp4Difference(std::istream& file, const WrittenForm& form, const Payload& payload);

}  // namespace rotatebook::video
