// The elements of a WebM as the program's own muxer writes them. Inside the room only.
#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string>

#include "video/clip_form.h"
#include "video/layout.h"

namespace rotatebook::video {

/// Reads the length of an element's content; nothing if it isn't stated. [bytes]
std::optional<std::uint64_t> webmLengthIn(std::istream& file);

/// Returns the element at offset `at` of one that ends at `end`; nothing if there is none, or its
/// length isn't stated.
std::optional<Part> webmElementAt(std::istream& file, std::uint64_t at, std::uint64_t end);

/// Returns the first difference of the WebM `file`, which may be anything, from what the muxer
/// writes for `form` and the packets of `payload`; empty if there is none.
std::string webmDifference(std::istream& file, const WrittenForm& form, const Payload& payload);

}  // namespace rotatebook::video
