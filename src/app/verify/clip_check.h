// Results of single checks of a clip. Inside the room only.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "video/planes.h"

namespace rotatebook::verify {

/// A property of a clip, and the value that it should have.
struct ClipCheck {
  std::string what;      ///< The property: "size"
  std::string measured;  ///< "640x360"
  std::string wanted;    ///< The bound, or the value that it must have.
  bool passed = false;
};

/// A picture of a clip, compared with the frame drawn for it.
struct PictureCheck {
  std::int64_t frame = 0;  ///< Its index in the whole clip.
  video::Distance measured;
  video::Distance bound;
  /// Another frame to which the picture is clearly closer than to `frame`.
  std::optional<std::int64_t> closerTo{};

  bool passed() const {
    return !closerTo && measured.rms <= bound.rms && measured.worstBlock <= bound.worstBlock;
  }
};

}  // namespace rotatebook::verify
