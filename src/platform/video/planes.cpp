#include "video/planes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/error.h"
#include "base/number_text.h"
#include "video/pixel_converter.h"

namespace rotatebook::video {
namespace {

using Rgb = std::array<float, 3>;

// Weights of red and blue in luma, ITU-R BT.709, table 3.
constexpr float kRed = 0.2126F;
constexpr float kBlue = 0.0722F;
constexpr float kLumaSpan = 219.0F / 255, kColourSpan = 224.0F / 255;
constexpr float kBlack = 16, kGrey = 128, kOpaque = 255;

std::size_t area(int width, int height) {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

float luma(const Rgb& rgb) {
  return kRed * rgb[0] + (1 - kRed - kBlue) * rgb[1] + kBlue * rgb[2];
}

/// Returns the colour of 2 x 2 pixels, sited at their left column, between their rows: mixed from
/// them and the pixels around.
Rgb colourAt(const image::ImageView& picture, int left, int top) {
  constexpr std::array<float, 3> kAcross{0.25F, 0.5F, 0.25F};
  constexpr std::array<float, 4> kDown{0.125F, 0.375F, 0.375F, 0.125F};
  Rgb mixed{};
  for (int j = 0; j < 4; ++j) {
    const std::uint8_t* row = picture.row(std::clamp(top + j - 1, 0, picture.height - 1));
    for (int i = 0; i < 3; ++i) {
      const int x = std::clamp(left + i - 1, 0, picture.width - 1);
      const std::uint8_t* pixel =
          row + static_cast<std::ptrdiff_t>(x) * bytesPerPixel(picture.format);
      const float share = kDown[static_cast<std::size_t>(j)] * kAcross[static_cast<std::size_t>(i)];
      for (std::size_t channel = 0; channel < 3; ++channel)
        mixed[channel] += share * pixel[channel];
    }
  }
  return mixed;
}

void addColour(const image::ImageView& picture, Planes& planes) {
  for (int top = 0; top + 1 < picture.height; top += 2) {
    for (int left = 0; left + 1 < picture.width; left += 2) {
      const Rgb rgb = colourAt(picture, left, top);
      const float grey = luma(rgb);
      planes.u.push_back(kGrey + kColourSpan * (rgb[2] - grey) / (2 - 2 * kBlue));
      planes.v.push_back(kGrey + kColourSpan * (rgb[0] - grey) / (2 - 2 * kRed));
    }
  }
}

std::vector<float> planeOf(const AVFrame& frame, int plane, int width, int height) {
  std::vector<float> values;
  values.reserve(area(width, height));
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* row =
        frame.data[plane] + static_cast<std::ptrdiff_t>(y) * frame.linesize[plane];
    values.insert(values.end(), row, row + width);
  }
  return values;
}

/// Returns the largest difference of two samples.
float farthest(const std::vector<float>& a, const std::vector<float>& b) {
  float largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// Sums of squared errors in blocks.
class BlockErrors {
 public:
  BlockErrors(int width, int height)
      : columns_(std::max(1, width / kBlockSide)), rows_(std::max(1, height / kBlockSide)) {
    squares_.resize(area(columns_, rows_));
    counts_.resize(squares_.size());
  }

  /// Adds planes of `width` samples a row, `side` samples to a block's side.
  void add(const std::vector<float>& a, const std::vector<float>& b, int width, int side) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      const auto at = static_cast<int>(i);
      const int row = std::min(at / width / side, rows_ - 1);
      const int column = std::min(at % width / side, columns_ - 1);
      const std::size_t block = area(row, columns_) + static_cast<std::size_t>(column);
      const double difference = a[i] - b[i];
      squares_[block] += difference * difference;
      counts_[block] += 1;
    }
  }

  Distance distance() const {
    double squares = 0, count = 0, worst = 0;
    for (std::size_t i = 0; i < squares_.size(); ++i) {
      squares += squares_[i];
      count += counts_[i];
      worst = std::max(worst, squares_[i] / counts_[i]);
    }
    return {std::sqrt(squares / count), std::sqrt(worst)};
  }

 private:
  int columns_;
  int rows_;
  std::vector<double> squares_;
  std::vector<double> counts_;
};

}  // namespace

Planes planesOf(image::ImageView picture, bool transparent) {
  Planes planes{.width = picture.width, .height = picture.height};
  planes.y.reserve(area(picture.width, picture.height));
  const int step = bytesPerPixel(picture.format);
  const bool hasAlpha = transparent && picture.format == image::PixelFormat::Rgba8;
  for (int y = 0; y < picture.height; ++y) {
    const std::uint8_t* pixel = picture.row(y);
    for (int x = 0; x < picture.width; ++x, pixel += step) {
      const Rgb rgb{1.0F * pixel[0], 1.0F * pixel[1], 1.0F * pixel[2]};
      planes.y.push_back(kBlack + kLumaSpan * luma(rgb));
      if (hasAlpha) planes.alpha.push_back(pixel[3]);
    }
  }
  addColour(picture, planes);
  return planes;
}

Planes planesOf(const AVFrame& frame) {
  Planes planes{.width = frame.width, .height = frame.height};
  planes.y = planeOf(frame, 0, frame.width, frame.height);
  planes.u = planeOf(frame, 1, frame.width / 2, frame.height / 2);
  planes.v = planeOf(frame, 2, frame.width / 2, frame.height / 2);
  if (frame.format == AV_PIX_FMT_YUVA420P) {
    planes.alpha = planeOf(frame, 3, frame.width, frame.height);
  }
  return planes;
}

Planes planesToEncode(image::ImageView picture, bool transparent) {
  constexpr float kRounding = 0.55F;  // measured 0.508
  const Planes exact = planesOf(picture, transparent);
  Planes planes =
      planesOf(PixelConverter(picture.width, picture.height, transparent).convert(picture));
  const float error = std::max(
      {farthest(planes.y, exact.y), farthest(planes.u, exact.u), farthest(planes.v, exact.v)});
  if (error <= kRounding) return planes;
  throw MachineError("a colour is converted " + shortestText(error) +
                     " of 255 away from what BT.709 says");
}

Distance distance(const Planes& a, const Planes& b) {
  if (a.width != b.width || a.height != b.height) {
    throw InputError("can't compare pictures of different sizes");
  }
  BlockErrors errors(a.width, a.height);
  errors.add(a.y, b.y, a.width, kBlockSide);
  errors.add(a.u, b.u, a.width / 2, kBlockSide / 2);
  errors.add(a.v, b.v, a.width / 2, kBlockSide / 2);
  if (!a.alpha.empty() || !b.alpha.empty()) {
    const std::vector<float> opaque(a.y.size(), kOpaque);
    errors.add(a.alpha.empty() ? opaque : a.alpha, b.alpha.empty() ? opaque : b.alpha, a.width,
               kBlockSide);
  }
  return errors.distance();
}

}  // namespace rotatebook::video
