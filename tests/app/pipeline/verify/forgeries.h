// Changes of pictures that a forger might hope for to pass.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "image/image.h"

namespace rotatebook::pipeline::testing {

/// A change of each picture of a clip.
struct PictureForgery {
  std::string name;  ///< As docs/verify.md has it: "hue turned by 5°"
  std::function<void(image::Image&)> apply;
};

/// Returns all forgeries of the table in docs/verify.md, in its order.
std::vector<PictureForgery> forgeries();

}  // namespace rotatebook::pipeline::testing
