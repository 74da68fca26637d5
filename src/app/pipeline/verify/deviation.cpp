#include "pipeline/verify/deviation.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>
#include <vector>

namespace rotatebook::pipeline {
namespace {

using Samples = std::vector<float>;
using Colour = std::complex<double>;

constexpr int kPatchSide = 32;  // [pixels]
constexpr int kDetailSide = 8;  // [pixels]

Samples differences(const Samples& a, const Samples& b) {
  Samples result(a.size());
  std::ranges::transform(a, b, result.begin(), std::minus<>{});
  return result;
}

/// Fits, by least squares, the change gain * value + offset to samples' changes.
class LinearFit {
 public:
  void add(Colour value, Colour change) {
    ++count_;
    values_ += value;
    changes_ += change;
    squares_ += std::norm(value);
    products_ += std::conj(value) * change;
  }

  /// Returns the root mean square of the fitted change.
  double rms() const {
    const Colour value = values_ / count_, change = changes_ / count_;
    const double variance = squares_ / count_ - std::norm(value);
    const Colour covariance = products_ / count_ - std::conj(value) * change;
    constexpr double kFlat = 1e-9;  // Below it there is nothing to fit a gain to.
    const double fitted = variance > kFlat ? std::norm(covariance) / variance : 0;
    return std::sqrt(std::norm(change) + fitted);
  }

 private:
  double count_ = 0;
  double squares_ = 0;
  Colour values_, changes_, products_;
};

Samples squaresOf(const Samples& values) {
  Samples result(values.size());
  std::ranges::transform(values, values, result.begin(), std::multiplies<>{});
  return result;
}

double brightnessChange(const Samples& drawn, const Samples& change) {
  LinearFit fit;
  for (std::size_t i = 0; i < drawn.size(); ++i) fit.add(drawn[i], change[i]);
  return fit.rms();
}

/// A complex gain turns the hue by its angle and scales the saturation by its length.
double colourChange(const video::Planes& drawn, const Samples& u, const Samples& v) {
  LinearFit fit;
  for (std::size_t i = 0; i < u.size(); ++i) fit.add({drawn.u[i], drawn.v[i]}, {u[i], v[i]});
  return fit.rms();
}

/// A change of luma from pixel to pixel.
struct Slope {
  double dx = 0, dy = 0;
};

/// Calls `action` with the index and the slope of each pixel that has neighbours on all sides.
template <typename Action>
void forEachSlope(const Samples& luma, int width, int height, const Action& action) {
  const auto stride = static_cast<std::size_t>(width);
  for (int y = 1; y + 1 < height; ++y) {
    const std::size_t row = static_cast<std::size_t>(y) * stride;
    for (std::size_t i = row + 1; i + 1 < row + stride; ++i) {
      action(i,
             Slope{(luma[i + 1] - luma[i - 1]) / 2.0, (luma[i + stride] - luma[i - stride]) / 2.0});
    }
  }
}

/// Returns the length of one step of Lucas and Kanade's method over the whole picture (Lucas and
/// Kanade 1981: An iterative image registration technique).
double shiftOf(const Samples& drawn, const Samples& change, int width, int height) {
  double xx = 0, xy = 0, yy = 0, xt = 0, yt = 0;
  forEachSlope(drawn, width, height, [&](std::size_t i, const Slope& slope) {
    const auto [dx, dy] = slope;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
    xt += dx * change[i];
    yt += dy * change[i];
  });
  const double determinant = xx * yy - xy * xy;
  constexpr double kSingular = 1e-3;  // Nearly all edges are parallel: one direction is unknown.
  if (determinant <= kSingular * xx * yy) return 0;
  return std::hypot(yy * xt - xy * yt, xx * yt - xy * xt) / determinant;
}

/// Returns the starts of windows of `size` in `length`: every half window, and at the end.
std::vector<std::size_t> windowsIn(std::size_t length, std::size_t size) {
  std::vector<std::size_t> starts;
  for (std::size_t at = 0; at + size < length; at += size / 2) starts.push_back(at);
  starts.push_back(length - size);
  return starts;
}

/// Returns the largest mean, either way, of `side` x `side` samples.
double largestMean(const Samples& change, int width, int height, int side) {
  // Sums over all samples above and left of each
  const auto stride = static_cast<std::size_t>(width) + 1;
  std::vector<double> sums(stride * (static_cast<std::size_t>(height) + 1));
  for (std::size_t i = 0, at = stride; at < sums.size(); ++at) {
    if (at % stride == 0) continue;
    sums[at] = change[i++] + sums[at - 1] + sums[at - stride] - sums[at - stride - 1];
  }
  const auto columns = static_cast<std::size_t>(std::min(side, width));
  const auto rows = static_cast<std::size_t>(std::min(side, height));
  double largest = 0;
  for (const std::size_t top : windowsIn(static_cast<std::size_t>(height), rows)) {
    for (const std::size_t left : windowsIn(stride - 1, columns)) {
      const double* above = &sums[top * stride + left];
      const double* below = above + rows * stride;
      largest = std::max(largest, std::abs(below[columns] - below[0] - above[columns] + above[0]));
    }
  }
  return largest / static_cast<double>(rows * columns);
}

/// Sums over a block of 16x16 pixels.
struct BlockSums {
  double values = 0, squares = 0;  ///< Of drawn luma.
  double errors = 0;               ///< Of the squares of the errors.

  void add(double value, double error) {
    values += value;
    squares += value * value;
    errors += error * error;
  }
  bool showsTexture() const {
    constexpr double kTexture = 3;  // Standard deviation of luma: flat areas cost no bits. [of 255]
    return squares / kArea - values * values / (kArea * kArea) > kTexture * kTexture;
  }
  double rms() const { return std::sqrt(errors / kArea); }

  static constexpr double kArea = video::kBlockSide * video::kBlockSide;
};

BlockSums sumsAt(const video::Planes& picture, const video::Planes& drawn, int left, int top) {
  BlockSums sums;
  for (int y = top; y < top + video::kBlockSide; ++y) {
    for (int x = left; x < left + video::kBlockSide; ++x) {
      const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(drawn.width) +
                     static_cast<std::size_t>(x);
      sums.add(drawn.y[i], picture.y[i] - drawn.y[i]);
    }
  }
  return sums;
}

}  // namespace

std::optional<double> codingNoise(const video::Planes& picture, const video::Planes& drawn) {
  constexpr std::size_t kMinBlocks = 16;  // Fewer make no reliable quartile.
  std::vector<double> errors;
  for (int top = 0; top + video::kBlockSide <= drawn.height; top += video::kBlockSide) {
    for (int left = 0; left + video::kBlockSide <= drawn.width; left += video::kBlockSide) {
      const BlockSums sums = sumsAt(picture, drawn, left, top);
      if (sums.showsTexture()) errors.push_back(sums.rms());
    }
  }
  if (errors.size() < kMinBlocks) return std::nullopt;
  const auto quartile = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() * 3 / 4);
  std::ranges::nth_element(errors, quartile);
  return *quartile;
}

double roomOfShift(const video::Planes& drawn) {
  // The share of pixels in edges of scenes/starter.toml: measured 0.024 at 1280x720 to 0.1 at
  // 64x36.
  constexpr double kUsualShare = 0.02;
  double squares = 0, fourths = 0;
  forEachSlope(drawn.y, drawn.width, drawn.height, [&](std::size_t, const Slope& slope) {
    const double square = slope.dx * slope.dx + slope.dy * slope.dy;
    squares += square;
    fourths += square * square;
  });
  const double edges = fourths > 0 ? squares * squares / fourths : 1;  // As many equal slopes.
  const double usual = kUsualShare * drawn.width * drawn.height;
  return std::max(std::pow(usual / edges, 0.25), 1.0);
}

bool isWithin(const Deviation& measured, const Deviation& bound) {
  return std::ranges::all_of(
      kMeasures, [&](const MeasureRow& row) { return measured.*row.value <= bound.*row.value; });
}

Deviation deviation(const video::Planes& picture, const video::Planes& drawn) {
  const video::Distance distance = video::distance(picture, drawn);
  const Samples y = differences(picture.y, drawn.y);
  const Samples u = differences(picture.u, drawn.u), v = differences(picture.v, drawn.v);
  const int width = drawn.width, height = drawn.height;
  const auto chroma = [&](const Samples& change) {
    return largestMean(change, width / 2, height / 2, kPatchSide / 2);
  };
  return {.rms = distance.rms,
          .worstBlock = distance.worstBlock,
          .detail = std::sqrt(largestMean(squaresOf(y), width, height, kDetailSide)),
          .brightness = brightnessChange(drawn.y, y),
          .colour = colourChange(drawn, u, v),
          .shift = shiftOf(drawn.y, y, width, height),
          .lumaPatch = largestMean(y, width, height, kPatchSide),
          .chromaPatch = std::max(chroma(u), chroma(v))};
}

}  // namespace rotatebook::pipeline
