#include "image/linear_mean.h"

#include <algorithm>
#include <cstddef>

namespace rotatebook::image {

LinearMean::LinearMean(int width, int height)
    : width_(width),
      height_(height),
      sums_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

void LinearMean::add(ImageView picture) {
  LinearAccumulator* sum = sums_.data();
  for (int y = 0; y < height_; ++y) {
    const std::uint8_t* pixel = picture.row(y);
    for (int x = 0; x < width_; ++x, pixel += 4) (sum++)->add(pixel, 1);
  }
  ++count_;
}

void LinearMean::take(Image& picture) {
  const LinearAccumulator* sum = sums_.data();
  for (int y = 0; y < height_; ++y) {
    std::uint8_t* pixel = picture.row(y);
    for (int x = 0; x < width_; ++x, pixel += 4) (sum++)->mean(count_, pixel);
  }
  std::ranges::fill(sums_, LinearAccumulator());
  count_ = 0;
}

}  // namespace rotatebook::image
