// What is found where a clip is verified. Inside the room only.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "video/planes.h"

namespace rotatebook::verify {

/// One thing that a clip tells, and what it should be.
struct ClipCheck {
  std::string what;      ///< "size"
  std::string measured;  ///< "640x360"
  std::string wanted;    ///< The bound, or what it must be.
  bool passed = false;
};

/// A picture of a clip beside the one that is drawn for it.
struct PictureCheck {
  std::int64_t frame = 0;  ///< Of the whole clip.
  video::Distance measured;
  video::Distance bound;
  /// Another frame than `frame` that it is clearly liker to.
  std::optional<std::int64_t> closerTo{};

  bool passed() const {
    return !closerTo && measured.rms <= bound.rms && measured.worstBlock <= bound.worstBlock;
  }
};

}  // namespace rotatebook::verify
