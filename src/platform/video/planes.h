// Pictures as a video stores them, and how alike two are.
#pragma once

#include <vector>

#include "image/image.h"

namespace rotatebook::video {

/// A picture in BT.709, limited range, its colour at half the size, sited left (yuv420p). Rows from
/// the top without padding. [0 to 255]
struct Planes {
  int width = 0;               ///< Even. [pixels]
  int height = 0;              ///< Even. [pixels]
  std::vector<float> y{};      ///< Of each pixel; black is 16, white 235.
  std::vector<float> u{};      ///< Of each 2 x 2 pixels; grey is 128.
  std::vector<float> v{};      ///< As `u`.
  std::vector<float> alpha{};  ///< Of each pixel; empty if all are opaque.
};

/// What the sRGB `picture`, of even size, is in that form, by the text of BT.709, not rounded: by
/// other code than what makes videos. Without its alpha unless `transparent`.
Planes planesOf(image::ImageView picture, bool transparent);

/// How far two pictures are apart. [of 255]
struct Distance {
  double rms = 0;         ///< Root of the mean square over all samples of all planes.
  double worstBlock = 0;  ///< The largest that it is in a patch of kBlockSide x kBlockSide pixels.
};

/// Patches that aren't whole belong to their neighbours.
inline constexpr int kBlockSide = 16;

/// Where one has alpha and the other hasn't, the other is opaque. Throws InputError if the sizes
/// differ.
Distance distance(const Planes& a, const Planes& b);

}  // namespace rotatebook::video
