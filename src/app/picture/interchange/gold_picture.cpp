#include "picture/interchange/gold_picture.h"

#include <algorithm>

#include "image/downsample.h"
#include "render/book_textures.h"

namespace rotatebook::interchange {

std::optional<image::Image> goldPicture(const image::Image& cover, int longestSide) {
  constexpr float kSmoother = 1 - kGoldRoughness / kClothRoughness;
  if (cover.width() == 1 && cover.height() == 1) return std::nullopt;
  image::Image marked = render::withGold(cover);
  while (std::max(marked.width(), marked.height()) > longestSide)
    marked = image::downsampledApart(marked.view());
  image::Image gold(marked.width(), marked.height(), image::PixelFormat::Rgb8);
  int most = 0;
  for (int y = 0; y < gold.height(); ++y) {
    const std::uint8_t* mark = marked.row(y) + 3;
    std::uint8_t* pixel = gold.row(y);
    for (int x = 0; x < gold.width(); ++x, mark += 4, pixel += 3) {
      const int share = 255 - *mark;
      most = std::max(most, share);
      pixel[1] = static_cast<std::uint8_t>(255.5F - kSmoother * static_cast<float>(share));
      pixel[2] = static_cast<std::uint8_t>(share);
    }
  }
  if (most < 128) return std::nullopt;
  return gold;
}

}  // namespace rotatebook::interchange
