// The mean of pictures, by their light.
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"
#include "image/linear_accumulator.h"

namespace rotatebook::image {

/// Averages up to 256 pictures of one size as LinearAccumulator does.
class LinearMean {
 public:
  /// Of pictures of this size, > 0. [pixels]
  LinearMean(int width, int height);

  /// Takes one more picture, of the size and Rgba8.
  void add(ImageView picture);
  /// Writes the mean of the pictures since the last call, of which there is at least one, over all
  /// of `picture`, of the size and Rgba8, and begins anew.
  void take(Image& picture);

 private:
  int width_;
  int height_;
  std::uint32_t count_ = 0;
  std::vector<LinearAccumulator> sums_;  // of each pixel, row by row
};

}  // namespace rotatebook::image
