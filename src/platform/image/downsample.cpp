#include "image/downsample.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "image/linear_accumulator.h"
#include "image/srgb.h"

namespace rotatebook::image {
namespace {

int half(int length) {
  return std::max(1, length / 2);
}

/// The pixels along a side that one pixel of the halved side covers.
struct Covered {
  std::size_t first = 0;
  std::size_t count = 0;
  /// Weights; their sum is the same for all pixels of the side.
  std::array<std::uint32_t, 3> shares{};
};

/// Returns what each pixel of a side covers after `length` pixels are halved.
std::vector<Covered> coveredBy(int length) {
  if (length == 1) return {{0, 1, {1}}};
  const auto count = static_cast<std::uint32_t>(half(length));
  std::vector<Covered> all;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (length % 2 == 0) {
      all.push_back({2 * i, 2, {1, 1}});
    } else {
      all.push_back({2 * i, 3, {count - i, count, i + 1}});
    }
  }
  return all;
}

std::uint32_t sumOfShares(const std::vector<Covered>& side) {
  return side[0].shares[0] + side[0].shares[1] + side[0].shares[2];
}

/// Returns a value of a pixel in linear light; alpha is in proportion to it already.
std::uint32_t linearOf(std::uint8_t value, std::size_t channel) {
  constexpr std::uint32_t kSteps = kMaxLinear / 255;
  return channel < 3 ? linearFromSrgb(value) : kSteps * value;
}

std::uint8_t valueOf(std::uint64_t linear, std::size_t channel) {
  constexpr std::uint32_t kSteps = kMaxLinear / 255;
  if (channel < 3) return srgbFromLinear(static_cast<std::uint32_t>(linear));
  return static_cast<std::uint8_t>((linear + kSteps / 2) / kSteps);
}

/// Sums the covered rows in linear light, weighted by their shares, sample by sample.
template <std::size_t kChannels>
void addRows(const ImageView& large, const Covered& rows, std::vector<std::uint32_t>& linear) {
  const int step = bytesPerPixel(large.format);
  std::ranges::fill(linear, 0);
  for (std::size_t i = 0; i < rows.count; ++i) {
    const std::uint8_t* pixel = large.row(static_cast<int>(rows.first + i));
    for (std::size_t at = 0; at < linear.size(); at += kChannels, pixel += step) {
      for (std::size_t channel = 0; channel < kChannels; ++channel)
        linear[at + channel] += rows.shares[i] * linearOf(pixel[channel], channel);
    }
  }
}

template <std::size_t kChannels>
Image halved(const ImageView& large) {
  Image picture(half(large.width), half(large.height),
                kChannels == 3 ? PixelFormat::Rgb8 : PixelFormat::Rgba8);
  const std::vector<Covered> columns = coveredBy(large.width), rows = coveredBy(large.height);
  const std::uint64_t all = std::uint64_t{sumOfShares(columns)} * sumOfShares(rows);
  std::vector<std::uint32_t> linear(kChannels * static_cast<std::size_t>(large.width));
  for (int y = 0; y < picture.height(); ++y) {
    addRows<kChannels>(large, rows[static_cast<std::size_t>(y)], linear);
    std::uint8_t* out = picture.row(y);
    for (const Covered& column : columns) {
      for (std::size_t channel = 0; channel < kChannels; ++channel) {
        std::uint64_t sum = all / 2;
        for (std::size_t i = 0; i < column.count; ++i) {
          sum += std::uint64_t{column.shares[i]} * linear[kChannels * (column.first + i) + channel];
        }
        *out++ = valueOf(sum / all, channel);
      }
    }
  }
  return picture;
}

}  // namespace

void downsample(const Image& large, const Area& area, const Pixels& picture) {
  const auto left = static_cast<std::ptrdiff_t>(area.x);
  for (int row = area.y; row < area.bottom(); ++row) {
    const std::uint8_t* upper = large.row(2 * row) + 8 * left;
    const std::uint8_t* lower = large.row(2 * row + 1) + 8 * left;
    std::uint8_t* pixel = picture.row(row) + 4 * left;
    for (int i = 0; i < area.width; ++i, upper += 8, lower += 8, pixel += 4) {
      LinearAccumulator sum;
      for (const std::uint8_t* one : {upper, upper + 4, lower, lower + 4}) sum.add(one, 1);
      sum.mean(4, pixel);
    }
  }
}

Image downsampledOpaque(const ImageView& large) {
  return halved<3>(large);
}

Image downsampledApart(const ImageView& large) {
  return halved<4>(large);
}

}  // namespace rotatebook::image
