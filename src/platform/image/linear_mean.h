// The mean of pictures in linear light.
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"
#include "image/linear_accumulator.h"

namespace rotatebook::image {

/// Averages up to 256 pictures of one size, pixel by pixel with LinearAccumulator.
class LinearMean {
 public:
  /// Averages pictures of this size, > 0. [pixels]
  LinearMean(int width, int height);

  /// Adds a picture of that size, Rgba8.
  void add(ImageView picture);
  /// Writes the mean of the pictures added since the last call, at least one, over all of
  /// `picture`, of that size and Rgba8, and starts again.
  void take(Image& picture);

 private:
  int width_;
  int height_;
  std::uint32_t count_ = 0;
  std::vector<LinearAccumulator> sums_;  // one per pixel, row by row
};

}  // namespace rotatebook::image
