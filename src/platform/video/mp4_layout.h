// The boxes of an MP4 as the program's own muxer writes them. Inside the room only.
#pragma once

#include <istream>
#include <string>

#include "video/clip_form.h"

namespace rotatebook::video {

/// Returns the first difference of the MP4 `file`, which may be anything, from what the muxer
/// writes for `form` and the packets of `payload`; empty if there is none.
std::string mp4Difference(std::istream& file, const WrittenForm& form, const Payload& payload);

}  // namespace rotatebook::video
