// Pictures as a video stores them, and the distance between two.
#pragma once

#include <vector>

#include "image/image.h"

struct AVFrame;

namespace rotatebook::video {

/// A picture in BT.709, limited range, its chroma at half the size, sited left (yuv420p). Rows from
/// the top, without padding. [0 to 255]
struct Planes {
  int width = 0;               ///< Even. [pixels]
  int height = 0;              ///< Even. [pixels]
  std::vector<float> y{};      ///< Luma of each pixel; black is 16, white 235.
  std::vector<float> u{};      ///< Blue chroma of each 2 x 2 pixels; grey is 128.
  std::vector<float> v{};      ///< Red chroma of each 2 x 2 pixels; grey is 128.
  std::vector<float> alpha{};  ///< Alpha of each pixel; empty if all are opaque.
};

/// Converts the sRGB `picture`, of even size, by the text of BT.709, not rounded and by other code
/// than videos are made with. Drops its alpha unless `transparent`.
Planes planesOf(image::ImageView picture, bool transparent);

/// Returns the samples of a frame in yuv420p or yuva420p, of even size.
Planes planesOf(const AVFrame& frame);

/// Converts the sRGB `picture` to the very samples that videos are encoded from: a flat colour may
/// be rounded by half a step all over. Drops its alpha unless `transparent`. Throws MachineError if
/// they differ from planesOf() by more than rounding.
Planes planesToEncode(image::ImageView picture, bool transparent);

/// Distance between two pictures. [of 255]
struct Distance {
  double rms = 0;         ///< Root mean square over all samples of all planes.
  double worstBlock = 0;  ///< Largest such error in a block of kBlockSide x kBlockSide pixels.
};

/// Side of a block; incomplete blocks belong to their neighbours. [pixels]
inline constexpr int kBlockSide = 16;

/// Measures how far two pictures are apart. If only one has alpha, the other counts as opaque.
/// Throws InputError if the sizes differ.
Distance distance(const Planes& a, const Planes& b);

}  // namespace rotatebook::video
