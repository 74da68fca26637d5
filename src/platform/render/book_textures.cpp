#include "render/book_textures.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "embedded/render.h"
#include "image/png_file.h"

namespace rotatebook::render {
namespace {

/// Returns how golden a colour is, 0 to 1, by the linear light of its parts.
float goldnessOf(float red, float green, float blue) {
  return std::clamp(5.5F * (green - 0.35F * red), 0.0F, 1.0F) *
         std::clamp(6 * (0.5F * red - blue), 0.0F, 1.0F);
}

/// Returns the linear light of each sRGB value, within 0.004.
std::array<float, 256> lights() {
  std::array<float, 256> all{};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const float value = static_cast<float>(i) / 255;
    all[i] = value * (value * (0.305306F * value + 0.682171F) + 0.012523F);
  }
  return all;
}

}  // namespace

image::Image builtinFront() {
  return image::decodePng(frontPng(), "built-in front cover");
}
image::Image builtinSpine() {
  return image::decodePng(spinePng(), "built-in spine");
}
image::Image builtinBack() {
  return image::decodePng(backPng(), "built-in back cover");
}
image::Image builtinPaper() {
  return image::decodePng(paperPng(), "built-in paper");
}

image::Image plainCloth(const Rgb& colour) {
  image::Image pixel(1, 1, image::PixelFormat::Rgb8);
  const std::uint8_t parts[] = {colour.red, colour.green, colour.blue};
  for (int i = 0; i < 3; ++i) pixel.row(0)[i] = parts[i];
  return pixel;
}

image::Image withGold(const image::Image& side) {
  image::Image made(side.width(), side.height(), image::PixelFormat::Rgba8);
  const bool isPlain = side.width() == 1 && side.height() == 1;
  const std::array<float, 256> light = lights();
  const int step = image::bytesPerPixel(side.format());
  for (int y = 0; y < side.height(); ++y) {
    const std::uint8_t* from = side.row(y);
    std::uint8_t* to = made.row(y);
    for (int x = 0; x < side.width(); ++x, from += step, to += 4) {
      std::copy_n(from, 3, to);
      const float gold = isPlain ? 0 : goldnessOf(light[from[0]], light[from[1]], light[from[2]]);
      to[3] = static_cast<std::uint8_t>(255 * (1 - gold) + 0.5F);
    }
  }
  return made;
}

}  // namespace rotatebook::render
