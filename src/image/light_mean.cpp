#include "image/light_mean.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "image/srgb.h"

namespace rotatebook::image {
namespace {

constexpr std::uint64_t kFullLight = 65'535;

/// The light of each sRGB number, of kFullLight.
const std::array<std::uint16_t, 256>& lights() {
  static const std::array<std::uint16_t, 256> table = [] {
    std::array<std::uint16_t, 256> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double light = linearFromSrgb(static_cast<std::uint8_t>(i));
      values[i] = static_cast<std::uint16_t>(std::lround(kFullLight * light));
    }
    return values;
  }();
  return table;
}

/// The sRGB number of each light.
const std::vector<std::uint8_t>& numbers() {
  static const std::vector<std::uint8_t> table = [] {
    std::vector<std::uint8_t> values;
    for (std::uint64_t i = 0; i <= kFullLight; ++i) {
      values.push_back(srgbFromLinear(static_cast<double>(i) / kFullLight));
    }
    return values;
  }();
  return table;
}

}  // namespace

LightMean::LightMean(int width, int height)
    : width_(width),
      height_(height),
      sums_(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

void LightMean::add(ImageView picture) {
  const auto& light = lights();
  std::uint64_t* sum = sums_.data();
  for (int y = 0; y < height_; ++y) {
    const std::uint8_t* pixel = picture.row(y);
    for (int x = 0; x < width_; ++x, pixel += 4, sum += 4) {
      const std::uint64_t alpha = pixel[3];
      for (int i = 0; i < 3; ++i) sum[i] += light[pixel[i]] * alpha;
      sum[3] += alpha;
    }
  }
  ++count_;
}

void LightMean::take(Image& picture) {
  const auto& number = numbers();
  const std::uint64_t* sum = sums_.data();
  for (int y = 0; y < height_; ++y) {
    std::uint8_t* pixel = picture.row(y);
    for (int x = 0; x < width_; ++x, pixel += 4, sum += 4) {
      const std::uint64_t alpha = sum[3];
      for (int i = 0; i < 3; ++i) {
        pixel[i] = alpha == 0 ? std::uint8_t{0} : number[(sum[i] + alpha / 2) / alpha];
      }
      pixel[3] = static_cast<std::uint8_t>((alpha + count_ / 2) / count_);
    }
  }
  std::ranges::fill(sums_, 0U);
  count_ = 0;
}

}  // namespace rotatebook::image
