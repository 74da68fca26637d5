// Closeness of the book's edges to many samples a pixel, beside four samples.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "image/linear_accumulator.h"
#include "render/drawing.h"

namespace rotatebook::render {
namespace {

using testing::book;
using testing::kX;
using testing::kY;
using testing::kZ;
using testing::plain;

constexpr int kSmoothWidth = 320, kSmoothHeight = 180, kFineness = 8;

// Without drawing on them: textures are as fine as pixels are, and that isn't the question here.
BookTextures plainCovers() {
  return {plain(8, 8, {150, 20, 30}), plain(8, 8, {120, 20, 40}), plain(8, 8, {200, 190, 170})};
}

std::vector<body::Cage> views() {
  std::vector<body::Cage> all;
  for (const auto& [x, y, z] : std::vector<std::array<double, 3>>{{-29, 32, 7},
                                                                  {52, -40, 17},
                                                                  {-20, -66, 11},
                                                                  {72, 9, -23},
                                                                  {17, 149, 6},
                                                                  {20, -34, 0},
                                                                  {11, 69, 6},
                                                                  {0, 0, 0}}) {
    all.push_back(book({{x, kX}, {y, kY}, {z, kZ}}));
  }
  all.push_back(testing::insideOutBook());
  return all;
}

image::Image drawnAt(int scale, const body::Cage& corners) {
  RenderSettings settings = testing::settingsOf(scale * kSmoothWidth, scale * kSmoothHeight);
  settings.camera = {{0, 0, 0.76}, {0, 0, 0}, {0, 1, 0}, 30};
  settings.background = Background::Plain;  // The studio's dither would count as an edge.
  settings.plainColour = {40, 43, 49};
  Renderer renderer(settings, plainCovers());
  return testing::drawn(renderer, corners);
}

/// The mean of the light at these places of each pixel's kFineness x kFineness.
image::Image meanOf(const image::Image& fine, const std::vector<std::pair<int, int>>& places) {
  image::Image picture(kSmoothWidth, kSmoothHeight, image::PixelFormat::Rgba8);
  for (int y = 0; y < kSmoothHeight; ++y) {
    for (int x = 0; x < kSmoothWidth; ++x) {
      image::LinearAccumulator sum;
      for (const auto& [dx, dy] : places) {
        sum.add(fine.row(kFineness * y + dy) + 4 * static_cast<std::ptrdiff_t>(kFineness * x + dx),
                1);
      }
      sum.mean(static_cast<std::uint32_t>(places.size()), picture.row(y) + 4 * x);
    }
  }
  return picture;
}

std::vector<std::pair<int, int>> allPlaces() {
  std::vector<std::pair<int, int>> places;
  for (int i = 0; i < kFineness * kFineness; ++i) places.emplace_back(i % kFineness, i / kFineness);
  return places;
}

struct Difference {
  double mean = 0;  // of all channels, of 255
  int largest = 0;
};

Difference differenceOf(const image::Image& one, const image::Image& other) {
  Difference difference;
  for (int y = 0; y < kSmoothHeight; ++y) {
    for (int x = 0; x < 4 * kSmoothWidth; ++x) {
      const int here = std::abs(one.row(y)[x] - other.row(y)[x]);
      difference.mean += here / (3.0 * kSmoothWidth * kSmoothHeight);
      difference.largest = std::max(difference.largest, here);
    }
  }
  return difference;
}

// Four samples as graphics hardware places them, and shaded each, which it doesn't even do.
TEST(Smoothness, ComesCloserTo64SamplesThanFourSamplesDo) {
  const std::vector<std::pair<int, int>> four{{3, 1}, {7, 3}, {0, 4}, {4, 6}};
  Difference ours, theirs;
  for (const body::Cage& corners : views()) {
    const image::Image fine = drawnAt(kFineness, corners);
    const image::Image reference = meanOf(fine, allPlaces());
    const Difference our = differenceOf(drawnAt(1, corners), reference);
    const Difference their = differenceOf(meanOf(fine, four), reference);
    ours = {ours.mean + our.mean, std::max(ours.largest, our.largest)};
    theirs = {theirs.mean + their.mean, std::max(theirs.largest, their.largest)};
  }
  EXPECT_LT(ours.mean, theirs.mean);        // measured 0.76 and 1.10, sums over the views
  EXPECT_LT(ours.largest, theirs.largest);  // measured 39 and 66
}

}  // namespace
}  // namespace rotatebook::render
