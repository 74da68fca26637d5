#include "image/smaller.h"

#include <array>
#include <cstddef>

#include "image/light_sum.h"

namespace rotatebook::image {

void halve(const Image& large, Image& picture) {
  for (int y = 0; y < picture.height(); ++y) {
    const std::uint8_t *upper = large.row(2 * y), *lower = large.row(2 * y + 1);
    std::uint8_t* pixel = picture.row(y);
    for (int x = 0; x < picture.width(); ++x, upper += 8, lower += 8, pixel += 4) {
      LightSum sum;
      for (const std::uint8_t* one : {upper, upper + 4, lower, lower + 4}) sum.add(one, 1);
      sum.mean(4, pixel);
    }
  }
}

}  // namespace rotatebook::image
