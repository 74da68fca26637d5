#include "render/straight_alpha.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "image/srgb.h"

namespace rotatebook::render {

void makeAlphaStraight(image::Image& picture, const PixelRect& area) {
  for (int y = area.y; y < area.y + area.height; ++y) {
    std::uint8_t* pixel = picture.row(y) + 4 * static_cast<std::ptrdiff_t>(area.x);
    for (int x = 0; x < area.width; ++x, pixel += 4) {
      if (pixel[3] == 255) continue;
      const double share = pixel[3] / 255.0;
      for (int i = 0; i < 3; ++i) {
        const double light = share > 0 ? image::linearFromSrgb(pixel[i]) / share : 0;
        pixel[i] = image::srgbFromLinear(std::min(light, 1.0));
      }
    }
  }
}

}  // namespace rotatebook::render
