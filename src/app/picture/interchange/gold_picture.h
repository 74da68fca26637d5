// Gold on the book's covers, for other programs. Inside the room only.
#pragma once

#include <optional>

#include "image/image.h"

namespace rotatebook::interchange {

inline constexpr float kClothRoughness = 0.45F, kGoldRoughness = 0.26F;  // As cover.frag has them.

/// Returns where a cover has gold, with sides of up to so many pixels: blue is metalness, green
/// multiplies kClothRoughness. None of a cover without gold.
std::optional<image::Image> goldPicture(const image::Image& cover, int longestSide);

}  // namespace rotatebook::interchange
