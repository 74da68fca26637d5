#include "render/antialias/edge_samples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "image/linear_accumulator.h"

namespace rotatebook::render {
namespace {

using Eigen::Vector3f;

constexpr int kSamples = EdgeSamples::kSamples;

/// Places within a pixel, from its middle: in each of 16 columns and rows one.
constexpr std::array<std::array<float, 2>, kSamples> kPlaces = [] {
  constexpr std::array<int, kSamples> kRows{5, 9, 13, 1, 10, 6, 2, 14, 3, 15, 7, 11, 0, 12, 8, 4};
  std::array<std::array<float, 2>, kSamples> places{};
  for (std::size_t i = 0; i < kSamples; ++i) {
    places[i] = {(static_cast<float>(i) + 0.5F) / kSamples - 0.5F,
                 (static_cast<float>(kRows[i]) + 0.5F) / kSamples - 0.5F};
  }
  return places;
}();

using Four [[gnu::vector_size(4 * sizeof(float))]] = float;

/// The same, four by four.
constexpr std::array<Four, kSamples / 4> placesAlong(std::size_t axis) {
  std::array<Four, kSamples / 4> all{};
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] = Four{kPlaces[4 * i][axis], kPlaces[4 * i + 1][axis], kPlaces[4 * i + 2][axis],
                  kPlaces[4 * i + 3][axis]};
  }
  return all;
}
constexpr auto kAcross = placesAlong(0), kDown = placesAlong(1);

/// A function that is linear over the picture.
struct Plane {
  float x, y, constant;

  float at(float px, float py) const { return x * px + y * py + constant; }
  /// How much it changes within half a pixel.
  float reach() const { return 0.5F * (std::abs(x) + std::abs(y)); }
};

/// 0 on the line from `a` to `b`, positive toward `inner`.
Plane edgePlane(const Vector3f& a, const Vector3f& b, const Vector3f& inner) {
  Plane plane{a.y() - b.y(), b.x() - a.x(), 0};
  plane.constant = -plane.at(a.x(), a.y());
  if (plane.at(inner.x(), inner.y()) >= 0) return plane;
  return {-plane.x, -plane.y, -plane.constant};
}

/// A triangle as planes; of none if it is seen from its edge.
struct Coverage {
  std::array<Plane, 3> edges;
  Plane depth;
};

std::optional<Coverage> coverOf(const ScreenTriangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  const Vector3f ab = b - a, ac = c - a;
  const float area = ab.x() * ac.y() - ab.y() * ac.x();
  if (area == 0 || !std::isfinite(area)) return std::nullopt;
  Plane depth{(ab.z() * ac.y() - ab.y() * ac.z()) / area,
              (ab.x() * ac.z() - ab.z() * ac.x()) / area, 0};
  depth.constant = a.z() - depth.at(a.x(), a.y());
  return Coverage{{edgePlane(a, b, c), edgePlane(b, c, a), edgePlane(c, a, b)}, depth};
}

/// Which pixels of each row can lie in all of some edges, and between `left` and `right`: edges of
/// a triangle that is seen from its side may all face one way by rounding, and bound nothing.
class RowSpans {
 public:
  RowSpans(const std::array<Plane, 3>& edges, float left, float right)
      : left_(left), right_(right) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const Plane& edge = edges[i];
      lefts_[i] = {0, left};
      rights_[i] = {0, right};
      if (edge.x == 0) continue;  // It ends rows, not what is in them.
      const float per = -1 / edge.x;
      const Border border{edge.y * per, (edge.constant + edge.reach()) * per};
      if (edge.x > 0) lefts_[i] = {border.slope, border.start - 0.5F};
      if (edge.x < 0) rights_[i] = {border.slope, border.start + 0.5F};
    }
  }

  /// The first pixel, and one past the last, of the row whose middle is `y`.
  std::pair<int, int> at(float y) const {
    const auto place = [y](const Border& border) { return border.slope * y + border.start; };
    const float left = std::max({left_, place(lefts_[0]), place(lefts_[1]), place(lefts_[2])});
    const float right = std::min({right_, place(rights_[0]), place(rights_[1]), place(rights_[2])});
    if (!(left < right)) return {0, 0};
    return {static_cast<int>(left), static_cast<int>(std::ceil(right))};
  }

 private:
  struct Border {
    float slope, start;
  };

  float left_, right_;
  std::array<Border, 3> lefts_, rights_;
};

/// Steps to the pixels around one and to itself, the nearest first.
const std::vector<std::array<int, 2>>& around() {
  static const std::vector<std::array<int, 2>> steps = [] {
    constexpr int kReach = 4;
    std::vector<std::array<int, 2>> all;
    for (int y = -kReach; y <= kReach; ++y) {
      for (int x = -kReach; x <= kReach; ++x) all.push_back({x, y});
    }
    std::ranges::stable_sort(all, {}, [](const auto& s) { return s[0] * s[0] + s[1] * s[1]; });
    return all;
  }();
  return steps;
}

/// Adds a pixel's colour, whatever its alpha says.
void addOpaque(const std::uint8_t* pixel, std::uint32_t times, image::LinearAccumulator& sum) {
  const std::array<std::uint8_t, 4> opaque{pixel[0], pixel[1], pixel[2], 255};
  sum.add(opaque.data(), times);
}

/// Which surfaces a pixel's samples show, and how many of them each.
struct Counts {
  void add(int surface) {
    std::size_t i = 0;
    while (i < size && shown[i] != surface) ++i;
    if (i == size) shown[size++] = surface;
    ++counts[i];
  }

  std::array<int, kSamples> shown;  // the first `size`
  std::array<std::uint32_t, kSamples> counts{};
  std::size_t size = 0;
};

/// A picture's pixel as the drawn book and what is behind it make it.
class PixelMixer {
 public:
  PixelMixer(const EdgePixels& pixels, const image::Image& drawn, const DrawnStrips& strips,
             const image::Image& background)
      : pixels_(pixels), drawn_(drawn), strips_(strips), background_(background) {}

  /// Whether the pixel, all of whose samples show this, is right as it was drawn, or shows what
  /// isn't among the triangles.
  bool isPlain(int x, int y, int shown) const { return shown == 0 || shown == surface(x, y); }

  void mix(int x, int y, const Counts& counts, std::uint8_t* pixel) {
    image::LinearAccumulator sum;
    std::uint32_t found = 0;
    for (std::size_t i = 0; i < counts.size; ++i) {
      const int surface = counts.shown[i];
      const std::uint32_t count = counts.counts[i];
      if (surface == 0) {
        sum.add(background_.row(y) + 4 * static_cast<std::ptrdiff_t>(x), count);
      } else if (surface > kMaxSurfaceId) {
        addOpaque(ofStrip(x, y, surface - kMaxSurfaceId - 1).data(), count, sum);
      } else if (const std::uint8_t* shown = nearest(x, y, static_cast<std::uint8_t>(surface))) {
        addOpaque(shown, count, sum);
      } else {
        continue;
      }
      found += count;
    }
    if (found > 0) sum.mean(found, pixel);
  }

 private:
  /// 0 beside the picture, too.
  std::uint8_t surface(int x, int y) const {
    const bool within = x >= 0 && x < drawn_.width() && y >= 0 && y < drawn_.height();
    return within ? std::min(drawn_.row(y)[4 * x + 3], kHighest) : std::uint8_t{0};
  }

  const std::uint8_t* pixelAt(int x, int y) const {
    return drawn_.row(y) + 4 * static_cast<std::ptrdiff_t>(x);
  }

  /// A strip's colour beside a pixel.
  std::array<std::uint8_t, 4> ofStrip(int x, int y, int number) const {
    const ScreenStrip& strip = strips_.seen[static_cast<std::size_t>(number)];
    const float share = strip.shareAt({static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F});
    // In 256ths of a column, from the middle of the first one.
    constexpr int kParts = 256;
    const int last = kParts * (static_cast<int>(strip.columns) - 1);
    const int there = static_cast<int>(kParts * strip.columns * share) - kParts / 2;
    const int place = std::clamp(there, 0, last - 1);
    const std::uint8_t* one = strips_.colours.row(number) + 4 * (place / kParts);
    std::array<std::uint8_t, 4> colour{};
    for (std::size_t i = 0; i < 3; ++i) {
      const int mixed = one[i] * (kParts - place % kParts) + one[i + 4] * (place % kParts);
      colour[i] = static_cast<std::uint8_t>((mixed + kParts / 2) / kParts);
    }
    return colour;
  }

  /// The nearest pixel that shows a surface; or its mean colour along edges, if none close by does;
  /// or the nearest pixel of the book, if none at all does; null if there is none.
  const std::uint8_t* nearest(int x, int y, std::uint8_t wanted) {
    const std::uint8_t* other = nullptr;
    for (const auto& [dx, dy] : around()) {
      const std::uint8_t there = surface(x + dx, y + dy);
      if (there == 0 || (other != nullptr && there != wanted)) continue;
      if (there == wanted) return pixelAt(x + dx, y + dy);
      other = pixelAt(x + dx, y + dy);
    }
    if (!hasMeans_) findMeans();
    return means_[wanted][3] > 0 ? means_[wanted].data() : other;
  }

  void findMeans() {
    std::array<image::LinearAccumulator, kMaxSurfaceId + 1> sums{};
    std::array<std::uint32_t, kMaxSurfaceId + 1> counts{};
    for (int y = 0; y < pixels_.height(); ++y) {
      pixels_.forEach(y, 0, pixels_.width(), [&](int x, std::size_t) {
        const std::uint8_t here = surface(x, y);
        if (counts[here]++ < kMaxOfMean) addOpaque(pixelAt(x, y), 1, sums[here]);
      });
    }
    for (std::size_t i = 1; i < means_.size(); ++i) {
      if (counts[i] > 0) sums[i].mean(std::min(counts[i], kMaxOfMean), means_[i].data());
    }
    hasMeans_ = true;
  }

  static constexpr std::uint8_t kHighest = kMaxSurfaceId;
  static constexpr std::uint32_t kMaxOfMean = 256;  // pixels, as LinearAccumulator takes

  const EdgePixels& pixels_;
  const image::Image& drawn_;
  const DrawnStrips& strips_;
  const image::Image& background_;
  bool hasMeans_ = false;                                               // They are seldom needed.
  std::array<std::array<std::uint8_t, 4>, kMaxSurfaceId + 1> means_{};  // by surface
};

}  // namespace

void EdgeSamples::cover(const EdgePixels& pixels, const ScreenTriangle& triangle) {
  const std::optional<Coverage> cover = coverOf(triangle);
  if (!cover) return;
  const auto& [a, b, c] = triangle.corners;
  const Eigen::Array2f size(static_cast<float>(pixels.width()),
                            static_cast<float>(pixels.height()));
  const Eigen::Array2f least = a.cwiseMin(b).cwiseMin(c).head<2>().array().max(0.0F);
  const Eigen::Array2f most = a.cwiseMax(b).cwiseMax(c).head<2>().array().min(size);
  if ((least >= most).any()) return;  // It lies beside the picture.
  const auto& [first, second, third] = cover->edges;
  // By how much each sample's value differs from that in the middle of its pixel.
  const auto differences = [](const Plane& plane) {
    Samples all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = plane.x * kAcross[i] + plane.y * kDown[i];
    return all;
  };
  const Samples inFirst = differences(first), inSecond = differences(second);
  const Samples inThird = differences(third), inDepth = differences(cover->depth);
  const RowSpans spans(cover->edges, least.x(), most.x());
  const Four surface = Four{} + triangle.surfaceId;
  for (int y = static_cast<int>(least.y()); static_cast<float>(y) < most.y(); ++y) {
    const float middle = static_cast<float>(y) + 0.5F;
    const auto [left, right] = spans.at(middle);
    pixels.forEach(y, left, right, [&](int x, std::size_t number) {
      const float place = static_cast<float>(x) + 0.5F;
      const float one = first.at(place, middle), two = second.at(place, middle);
      const float three = third.at(place, middle), far = cover->depth.at(place, middle);
      Samples &depths = depths_[number], &surfaces = surfaces_[number];
      for (std::size_t i = 0; i < depths.size(); ++i) {
        const Four depth = inDepth[i] + far;
        const auto seen = (inFirst[i] + one >= 0) & (inSecond[i] + two >= 0) &
                          (inThird[i] + three >= 0) & (depth < depths[i]);
        depths[i] = seen ? depth : depths[i];
        surfaces[i] = seen ? surface : surfaces[i];
      }
    });
  }
}

bool EdgeSamples::isOne(const Samples& surfaces) {
  const Four first = Four{} + surfaces[0][0];
  const auto same = (surfaces[0] == first) & (surfaces[1] == first) & (surfaces[2] == first) &
                    (surfaces[3] == first);
  return (same[0] & same[1] & same[2] & same[3]) != 0;
}

void EdgeSamples::resolve(const EdgePixels& pixels, std::span<const ScreenTriangle> triangles,
                          const image::Image& drawn, const DrawnStrips& strips,
                          const image::Image& background, image::Image& picture) {
  Samples farthest;
  farthest.fill(Four{} + std::numeric_limits<float>::max());
  depths_.assign(pixels.count(), farthest);
  surfaces_.assign(pixels.count(), Samples{});
  for (const ScreenTriangle& triangle : triangles) cover(pixels, triangle);
  PixelMixer mixer(pixels, drawn, strips, background);
  for (int y = 0; y < pixels.height(); ++y) {
    pixels.forEach(y, 0, pixels.width(), [&](int x, std::size_t number) {
      Counts counts;
      if (isOne(surfaces_[number])) {
        const int surface = static_cast<int>(surfaces_[number][0][0]);
        if (mixer.isPlain(x, y, surface)) return;
      }
      for (const Four& four : surfaces_[number]) {
        for (int i = 0; i < 4; ++i) counts.add(static_cast<int>(four[i]));
      }
      mixer.mix(x, y, counts, picture.row(y) + 4 * static_cast<std::ptrdiff_t>(x));
    });
  }
}

}  // namespace rotatebook::render
