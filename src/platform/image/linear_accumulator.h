// Sum of pixels in linear light.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "image/srgb.h"

namespace rotatebook::image {

/// Adds up to 256 pixels (Rgba8, straight alpha) as a film does: sRGB values are converted to
/// linear light, and pixels are weighted by their alpha.
class LinearAccumulator {
 public:
  /// Adds `pixel`, counted `times` times.
  void add(const std::uint8_t* pixel, std::uint32_t times) {
    const std::uint32_t alpha = times * pixel[3];
    for (std::size_t i = 0; i < 3; ++i) {
      linear_[i] += linearFromSrgb(pixel[i]) * alpha;
    }
    alpha_ += alpha;
  }

  /// Writes the mean of `count` pixels to `pixel`.
  void mean(std::uint32_t count, std::uint8_t* pixel) const {
    for (std::size_t i = 0; i < 3; ++i) {
      pixel[i] = alpha_ == 0 ? std::uint8_t{0} : srgbFromLinear((linear_[i] + alpha_ / 2) / alpha_);
    }
    pixel[3] = static_cast<std::uint8_t>((alpha_ + count / 2) / count);
  }

 private:
  std::array<std::uint32_t, 3> linear_{};  // 256 white pixels, rounded up, are below 2^32.
  std::uint32_t alpha_ = 0;
};

}  // namespace rotatebook::image
