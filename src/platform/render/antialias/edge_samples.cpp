#include "render/antialias/edge_samples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <optional>
#include <utility>

#include "image/linear_accumulator.h"
#include "image/wide_vectors.h"

namespace rotatebook::render {
namespace {

using Eigen::Vector3f;

constexpr int kSamples = EdgeSamples::kSamples;

/// A value of each sample of a pixel.
using Samples = EdgeSamples::Samples;
using Surfaces = EdgeSamples::Surfaces;
using PixelSamples = EdgeSamples::PixelSamples;

/// Sample positions relative to the pixel's middle, one in each of 16 columns and rows. [pixels]
struct Offsets {
  Samples x, y;
};
constexpr Offsets kOffsets = [] {
  constexpr std::array<int, kSamples> kRows{5, 9, 13, 1, 10, 6, 2, 14, 3, 15, 7, 11, 0, 12, 8, 4};
  Offsets offsets{};
  for (std::size_t i = 0; i < kSamples; ++i) {
    offsets.x[i] = (static_cast<float>(i) + 0.5F) / kSamples - 0.5F;
    offsets.y[i] = (static_cast<float>(kRows[i]) + 0.5F) / kSamples - 0.5F;
  }
  return offsets;
}();

/// A linear function of a position in the picture.
struct Plane {
  float x, y, constant;

  float at(float px, float py) const { return x * px + y * py + constant; }
  /// The largest change from a pixel's middle to its border.
  float reach() const { return 0.5F * (std::abs(x) + std::abs(y)); }
  /// Returns by how much it differs at the samples from its value in the pixel's middle.
  Samples differences() const {
    Samples all;
    for (std::size_t i = 0; i < kSamples; ++i) all[i] = x * kOffsets.x[i] + y * kOffsets.y[i];
    return all;
  }
};

/// Returns the edge function of the line from `a` to `b`: 0 on it, positive within a triangle of
/// this winding, 1 or -1.
Plane edgePlane(const Vector3f& a, const Vector3f& b, float winding) {
  Plane plane{winding * (a.y() - b.y()), winding * (b.x() - a.x()), 0};
  plane.constant = -plane.at(a.x(), a.y());
  return plane;
}

/// A triangle's edge functions and depth.
struct Coverage {
  std::array<Plane, 3> edges;
  Plane depth;
};

/// Computes a triangle's planes. Returns nothing if it is seen edge-on or isn't finite.
std::optional<Coverage> coverageOf(const ScreenTriangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  const Vector3f ab = b - a, ac = c - a;
  const float area = ab.x() * ac.y() - ab.y() * ac.x();
  if (area == 0 || !std::isfinite(area)) return std::nullopt;

  // Find the depth plane through the corners
  Plane depth{(ab.z() * ac.y() - ab.y() * ac.z()) / area,
              (ab.x() * ac.z() - ab.z() * ac.x()) / area, 0};
  depth.constant = a.z() - depth.at(a.x(), a.y());

  // One winding for all edges: from the side, where a corner lies on its opposite edge but for
  // rounding, edges that each turned toward that corner would bound a half of the picture
  const float winding = area > 0 ? 1 : -1;
  return Coverage{{edgePlane(a, b, winding), edgePlane(b, c, winding), edgePlane(c, a, winding)},
                  depth};
}

/// The pixels of each row that can lie within a triangle's edges, and between `left` and `right`:
/// along a triangle that is seen edge-on, its edges bound nothing but for rounding.
class RowSpans {
 public:
  RowSpans(const std::array<Plane, 3>& edges, float left, float right)
      : left_(left), right_(right) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const Plane& edge = edges[i];
      lefts_[i] = {0, left};
      rights_[i] = {0, right};
      if (edge.x == 0) continue;  // A horizontal edge doesn't bound a row's pixels.

      // Solve for the x where the edge function, raised by its reach, is 0; widen by half a pixel
      const float scale = -1 / edge.x;
      const Border border{edge.y * scale, (edge.constant + edge.reach()) * scale};
      if (edge.x > 0) lefts_[i] = {border.slope, border.start - 0.5F};
      if (edge.x < 0) rights_[i] = {border.slope, border.start + 0.5F};
    }
  }

  /// Returns the first pixel, and one past the last, of the row whose middle is `y`.
  std::pair<int, int> at(float y) const {
    const auto x = [y](const Border& border) { return border.slope * y + border.start; };
    const float left = std::max({left_, x(lefts_[0]), x(lefts_[1]), x(lefts_[2])});
    const float right = std::min({right_, x(rights_[0]), x(rights_[1]), x(rights_[2])});
    if (!(left < right)) return {0, 0};
    return {static_cast<int>(left), static_cast<int>(std::ceil(right))};
  }

 private:
  /// A line x = slope * y + start.
  struct Border {
    float slope, start;
  };

  float left_, right_;
  std::array<Border, 3> lefts_, rights_;
};

/// Adds a pixel's colour as opaque: its alpha holds a surface number.
void addOpaque(const std::uint8_t* pixel, std::uint32_t times, image::LinearAccumulator& sum) {
  const std::array<std::uint8_t, 4> opaque{pixel[0], pixel[1], pixel[2], 255};
  sum.add(opaque.data(), times);
}

/// Returns how many samples show a surface.
std::uint32_t countOf(std::int32_t surface, const Surfaces& surfaces) {
  std::uint32_t count = 0;
  for (const std::int32_t one : surfaces) count += one == surface ? 1 : 0;
  return count;
}

/// The surfaces that a pixel's samples show, with the number of samples of each.
struct SurfaceCounts {
  explicit SurfaceCounts(const Surfaces& samples) {
    if (isOfTwo(samples)) return;
    for (const std::int32_t surface : samples) add(surface);
  }

  /// Sets the counts if the samples show one surface, or two as along most edges: the other one's
  /// number follows from the sum of all.
  bool isOfTwo(const Surfaces& samples) {
    std::int32_t rest = 0;
    for (const std::int32_t surface : samples) rest += surface;
    const std::uint32_t first = countOf(samples[0], samples), others = kSamples - first;
    rest -= static_cast<std::int32_t>(first) * samples[0];
    const std::int32_t other = others == 0 ? 0 : rest / static_cast<std::int32_t>(others);
    if (others > 0 && (other == samples[0] || countOf(other, samples) != others)) return false;
    surfaces[0] = samples[0], surfaces[1] = other;
    counts[0] = first, counts[1] = others;
    size = others == 0 ? 1 : 2;
    return true;
  }

  void add(std::int32_t surface) {
    std::size_t i = 0;
    while (i < size && surfaces[i] != surface) ++i;
    if (i == size) surfaces[size++] = surface;
    ++counts[i];
  }

  Surfaces surfaces;  // The first `size` are set.
  std::array<std::uint32_t, kSamples> counts{};
  std::size_t size = 0;
};

/// Mixes a pixel's colour from the drawn body, its strips and the background.
class PixelMixer {
 public:
  PixelMixer(SurfaceColours colours, const DrawnStrips& strips, const image::Image& background)
      : colours_(std::move(colours)), strips_(strips), background_(background) {}

  /// Returns whether a pixel all of whose samples show `sampled` needs no mixing: it was drawn so,
  /// or it shows something that isn't among the triangles.
  bool isResolved(int x, int y, int sampled) const {
    return sampled == 0 || sampled == colours_.surfaceAt(x, y);
  }

  /// Sets `pixel` to the mean of its samples, or leaves it if no sample has a colour.
  void mix(int x, int y, const SurfaceCounts& samples, std::uint8_t* pixel) {
    image::LinearAccumulator sum;
    std::uint32_t found = 0;
    for (std::size_t i = 0; i < samples.size; ++i) {
      const int surface = samples.surfaces[i];
      const std::uint32_t count = samples.counts[i];
      if (surface == 0) {
        sum.add(background_.row(y) + 4 * static_cast<std::ptrdiff_t>(x), count);
      } else if (surface > geometry::kMaxSurfaceId) {
        addOpaque(stripColour(x, y, surface - geometry::kMaxSurfaceId - 1).data(), count, sum);
      } else if (const auto* colour = colours_.at(x, y, static_cast<std::uint8_t>(surface))) {
        addOpaque(colour, count, sum);
      } else {
        continue;
      }
      found += count;
    }
    if (found > 0) sum.mean(found, pixel);
  }

 private:
  /// Returns a strip's colour beside a pixel's middle.
  std::array<std::uint8_t, 4> stripColour(int x, int y, int number) const {
    const ScreenStrip& strip = strips_.onScreen[static_cast<std::size_t>(number)];
    const float share = strip.shareAt({static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F});

    // Find the position along the strip, in 256ths of a column from the first column's middle
    constexpr int kParts = 256;
    const int last = kParts * (static_cast<int>(strip.columns) - 1);
    const int unclamped = static_cast<int>(kParts * strip.columns * share) - kParts / 2;
    const int position = std::clamp(unclamped, 0, last - 1);

    // Interpolate linearly between two columns
    const std::uint8_t* left = strips_.colours.row(number) + 4 * (position / kParts);
    const int weight = position % kParts;
    std::array<std::uint8_t, 4> colour{};
    for (std::size_t i = 0; i < 3; ++i) {
      const int mixed = left[i] * (kParts - weight) + left[i + 4] * weight;
      colour[i] = static_cast<std::uint8_t>((mixed + kParts / 2) / kParts);
    }
    return colour;
  }

  SurfaceColours colours_;
  const DrawnStrips& strips_;
  const image::Image& background_;
};

/// A triangle that is rasterised within a part of the picture.
struct Rasterised {
  Coverage planes;
  Eigen::Array2f low, high;  // The corners of the part. [pixels]
  std::int32_t surface;
};

/// Depth-tests the samples of the edge pixels that a triangle can cover, row by row, as many
/// samples at once as a `Vector` holds. `samples`: by pixel number.
template <typename Vector, typename Numbers>
[[gnu::always_inline]] inline void rasteriseBy(const Rasterised& triangle, const EdgePixels& pixels,
                                               PixelSamples* samples) {
  constexpr std::size_t kAtOnce = sizeof(Vector) / sizeof(float);
  // No structured bindings: clang before 16 captures none in lambdas.
  const std::array<Plane, 3>& edges = triangle.planes.edges;
  const Plane &first = edges[0], &second = edges[1], &third = edges[2];
  const Plane& depthPlane = triangle.planes.depth;
  const Samples firstDifferences = first.differences(), secondDifferences = second.differences();
  const Samples thirdDifferences = third.differences();
  const Samples depthDifferences = depthPlane.differences();
  const Numbers surface = Numbers{} + triangle.surface;
  const RowSpans spans(triangle.planes.edges, triangle.low.x(), triangle.high.x());
  const auto end = triangle.high.y();
  for (int y = static_cast<int>(triangle.low.y()); static_cast<float>(y) < end; ++y) {
    const float middleY = static_cast<float>(y) + 0.5F;
    const auto [left, right] = spans.at(middleY);
    pixels.forEach(
        y, left, right, [&](int x, std::size_t number) __attribute__((always_inline)) {
          // Evaluate the planes in the pixel's middle
          const float middleX = static_cast<float>(x) + 0.5F;
          const float atFirst = first.at(middleX, middleY), atSecond = second.at(middleX, middleY);
          const float atThird = third.at(middleX, middleY);
          const float middleDepth = depthPlane.at(middleX, middleY);

          // Depth-test the samples within all edges
          for (std::size_t i = 0; i < kSamples; i += kAtOnce) {
            Vector toFirst, toSecond, toThird, depth, nearest;
            Numbers shown;
            std::memcpy(&toFirst, &firstDifferences[i], sizeof(Vector));
            std::memcpy(&toSecond, &secondDifferences[i], sizeof(Vector));
            std::memcpy(&toThird, &thirdDifferences[i], sizeof(Vector));
            const Numbers inside =
                (toFirst + atFirst >= 0) & (toSecond + atSecond >= 0) & (toThird + atThird >= 0);
            std::memcpy(&depth, &depthDifferences[i], sizeof(Vector));
            std::memcpy(&nearest, &samples[number].depths[i], sizeof(Vector));
            std::memcpy(&shown, &samples[number].surfaces[i], sizeof(Vector));
            depth += middleDepth;
            const Numbers visible = inside & (depth < nearest);
            nearest = visible ? depth : nearest;
            shown = visible ? surface : shown;
            std::memcpy(&samples[number].depths[i], &nearest, sizeof(Vector));
            std::memcpy(&samples[number].surfaces[i], &shown, sizeof(Vector));
          }
        });
  }
}

using Four [[gnu::vector_size(4 * sizeof(float))]] = float;
using FourNumbers [[gnu::vector_size(4 * sizeof(float))]] = std::int32_t;

void rasteriseByBase(const Rasterised& triangle, const EdgePixels& pixels, PixelSamples* samples) {
  rasteriseBy<Four, FourNumbers>(triangle, pixels, samples);
}

using Eight [[gnu::vector_size(8 * sizeof(float))]] = float;
using EightNumbers [[gnu::vector_size(8 * sizeof(float))]] = std::int32_t;

ROTATEBOOK_AVX2 void rasteriseByAvx2(const Rasterised& triangle, const EdgePixels& pixels,
                                     PixelSamples* samples) {
  rasteriseBy<Eight, EightNumbers>(triangle, pixels, samples);
}

const auto rasteriseAll = image::usesAvx2() ? &rasteriseByAvx2 : &rasteriseByBase;

}  // namespace

void EdgeSamples::rasterise(const EdgePixels& pixels, const ScreenTriangle& triangle) {
  const std::optional<Coverage> coverage = coverageOf(triangle);
  if (!coverage) return;

  // Clamp the triangle's bounding box to the picture
  const auto& [a, b, c] = triangle.corners;
  const Eigen::Array2f size(static_cast<float>(pixels.width()),
                            static_cast<float>(pixels.height()));
  const Eigen::Array2f low = a.cwiseMin(b).cwiseMin(c).head<2>().array().max(0.0F);
  const Eigen::Array2f high = a.cwiseMax(b).cwiseMax(c).head<2>().array().min(size);
  if ((low >= high).any()) return;
  rasteriseAll({*coverage, low, high, static_cast<std::int32_t>(triangle.surfaceId)}, pixels,
               pixels_.data());
}

void EdgeSamples::resolve(const EdgePixels& pixels, std::span<const ScreenTriangle> triangles,
                          const image::Image& drawn, const DrawnStrips& strips,
                          const image::Image& background, const image::Pixels& picture) {
  // Find the nearest surface at every sample of the edge pixels
  PixelSamples nothing{};
  nothing.depths.fill(std::numeric_limits<float>::max());
  pixels_.assign(pixels.count(), nothing);
  for (const ScreenTriangle& triangle : triangles) rasterise(pixels, triangle);

  PixelMixer mixer({alike_, pixels, drawn}, strips, background);
  for (int y = 0; y < pixels.height(); ++y) {
    pixels.forEach(y, 0, pixels.width(), [&](int x, std::size_t number) {
      // Leave a pixel that shows one surface and was drawn so
      const SurfaceCounts samples(pixels_[number].surfaces);
      if (samples.size == 1 && mixer.isResolved(x, y, samples.surfaces[0])) return;

      // Mix the colours of its surfaces by their numbers of samples
      mixer.mix(x, y, samples, picture.row(y) + 4 * static_cast<std::ptrdiff_t>(x));
    });
  }
}

}  // namespace rotatebook::render
