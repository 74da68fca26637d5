// The mean of pictures, by their light.
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"

namespace rotatebook::image {

/// Averages up to 256 pictures of one size as a film does: sRGB's numbers are taken back to light,
/// and pixels count by their alpha.
class LightMean {
 public:
  /// Of pictures of this size, > 0. [pixels]
  LightMean(int width, int height);

  /// Takes one more picture, of the size and Rgba8.
  void add(ImageView picture);
  /// Writes the mean of the pictures since the last call, of which there is at least one, over all
  /// of `picture`, of the size and Rgba8, and begins anew.
  void take(Image& picture);

 private:
  int width_;
  int height_;
  unsigned count_ = 0;
  /// Of each pixel, row by row: red, green and blue light times alpha, and alpha.
  std::vector<std::uint64_t> sums_;
};

}  // namespace rotatebook::image
