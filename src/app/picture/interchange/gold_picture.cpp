#include "picture/interchange/gold_picture.h"

#include <algorithm>

namespace rotatebook::interchange {
namespace {

/// Returns the linear light of an sRGB value, within 0.004.
float lightOf(std::uint8_t encoded) {
  const float value = static_cast<float>(encoded) / 255;
  return value * (value * (0.305306F * value + 0.682171F) + 0.012523F);
}

/// Returns how golden a colour is, 0 to 1, as cover.frag has it.
float goldnessOf(const std::uint8_t* pixel) {
  const float red = lightOf(pixel[0]), green = lightOf(pixel[1]), blue = lightOf(pixel[2]);
  return std::clamp(4 * (green - 0.35F * red), 0.0F, 1.0F) *
         std::clamp(6 * (0.5F * red - blue), 0.0F, 1.0F);
}

/// Returns the mean of two by two pixels of a cover, or of what there is of them.
float goldnessAt(const image::Image& cover, int x, int y) {
  float sum = 0;
  for (const int row : {2 * y, std::min(2 * y + 1, cover.height() - 1)}) {
    for (const int column : {2 * x, std::min(2 * x + 1, cover.width() - 1)})
      sum += goldnessOf(cover.row(row) + column * image::bytesPerPixel(cover.format()));
  }
  return sum / 4;
}

}  // namespace

std::optional<image::Image> goldPicture(const image::Image& cover) {
  constexpr float kSmoother = 1 - kGoldRoughness / kClothRoughness;
  if (cover.width() == 1 && cover.height() == 1) return std::nullopt;
  image::Image gold((cover.width() + 1) / 2, (cover.height() + 1) / 2, image::PixelFormat::Rgb8);
  float most = 0;
  for (int y = 0; y < gold.height(); ++y) {
    std::uint8_t* pixel = gold.row(y);
    for (int x = 0; x < gold.width(); ++x, pixel += 3) {
      const float share = goldnessAt(cover, x, y);
      most = std::max(most, share);
      pixel[1] = static_cast<std::uint8_t>(255 * (1 - kSmoother * share) + 0.5F);
      pixel[2] = static_cast<std::uint8_t>(255 * share + 0.5F);
    }
  }
  if (most < 0.5F) return std::nullopt;
  return gold;
}

}  // namespace rotatebook::interchange
