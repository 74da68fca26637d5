// Results of single checks of a clip. Inside the room only.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "pipeline/verify/deviation.h"

namespace rotatebook::pipeline {

/// The largest mean quantiser of a clip that can be proved, in the scale of video::PictureFacts. In
/// a coarser one the noise of encoding hides changes that people see.
inline constexpr double kCoarsestProof = 32;

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
  double quantiser = 0;    ///< With which it is coded, or what is copied in it.
  Deviation measured{};
  Deviation bound{};  ///< The largest that encoding explains.
  /// Another frame to which the picture is clearly closer than to `frame`.
  std::optional<std::int64_t> closerTo{};

  bool passed() const { return !closerTo && isWithin(measured, bound); }
};

}  // namespace rotatebook::pipeline
