// The book's distance from 64 samples a pixel, which is nowhere larger than that of OpenGL's four.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

#include "render/drawing.h"
#include "render/sampled_book.h"

namespace rotatebook::render {
namespace {

using testing::book;
using testing::kX;
using testing::kY;
using testing::kZ;
using testing::plain;
using testing::SampledBook;

constexpr int kFine = 8;

// Without drawing on them: textures are as fine as pixels are, and that isn't the question here.
BookTextures clothCovers() {
  return {plain(8, 8, {150, 20, 30}), plain(8, 8, {120, 20, 40}), plain(8, 8, {200, 190, 170})};
}

/// From the figures, where hinges, rims or leaves are seen from their sides. models at 1.45 s comes
/// first, then Figure 5 at 1.45 s, 3 at 8.88 s, and 4 at 9.99, 14.43, 7.35 and 0 s.
std::vector<body::Cage> sideViews() {
  std::vector<body::Cage> all;
  for (const auto& [x, y, z] : std::vector<std::array<double, 3>>{{152.3, 179.8, 179.7},
                                                                  {150.9, 179.8, 179.7},
                                                                  {179.7, -179.1, 48.9},
                                                                  {177.4, 63.9, 174.4},
                                                                  {-179.5, 129.5, 176.9},
                                                                  {-176.9, -55.6, 175.6},
                                                                  {0, 0, 0}}) {
    all.push_back(book({{x, kX}, {y, kY}, {z, kZ}}));
  }
  return all;
}

RenderSettings asInFigures(int width, int height, int bottomRows, double fieldOfViewDeg) {
  RenderSettings settings = testing::settingsOf(width, height);
  settings.bottomRows = bottomRows;
  settings.camera = {{0.272387, 0.194562, 0.648539}, {0, 0, 0}, {0, 1, 0}, fieldOfViewDeg};
  return settings;
}

/// 64 samples a pixel, each shaded by itself.
std::vector<image::Image> samplesOf(const RenderSettings& settings, const body::Cage& corners) {
  RenderSettings fine = settings;
  fine.width *= kFine;
  fine.height *= kFine;
  fine.bottomRows *= kFine;
  const image::Image all = SampledBook(fine, clothCovers()).drawn(corners);
  std::vector<image::Image> samples(
      kFine * kFine, image::Image(settings.width, settings.height, image::PixelFormat::Rgba8));
  for (int y = 0; y < all.height(); ++y) {
    for (int x = 0; x < all.width(); ++x) {
      image::Image& sample = samples[static_cast<std::size_t>(y % kFine * kFine + x % kFine)];
      std::copy_n(all.row(y) + 4 * static_cast<std::ptrdiff_t>(x), 4,
                  sample.row(y / kFine) + 4 * static_cast<std::ptrdiff_t>(x / kFine));
    }
  }
  return samples;
}

/// Distance of a picture from another one, of 255.
struct Distance {
  int largest = 0;    // of a channel
  int brightest = 0;  // of a channel that is brighter than it should be
  int farPixels = 0;  // by more than kFar
  double block = 0;   // root mean square of the worst 8x8 pixels
};

Distance distanceOf(const image::Image& one, const image::Image& other) {
  constexpr int kFar = 32, kBlock = 8;
  Distance distance;
  std::vector<double> squares(static_cast<std::size_t>(one.width() * one.height()));
  for (int y = 0; y < one.height(); ++y) {
    for (int x = 0; x < one.width(); ++x) {
      int largest = 0;
      for (int i = 4 * x; i < 4 * x + 3; ++i) {
        const int off = one.row(y)[i] - other.row(y)[i];
        largest = std::max(largest, std::abs(off));
        distance.brightest = std::max(distance.brightest, off);
        squares[static_cast<std::size_t>(y / kBlock * one.width() + x / kBlock)] += off * off;
      }
      distance.largest = std::max(distance.largest, largest);
      distance.farPixels += largest > kFar ? 1 : 0;
    }
  }
  distance.block = std::sqrt(std::ranges::max(squares) / (3 * kBlock * kBlock));
  return distance;
}

struct Distances {
  Distance ours, theirs;
};

std::vector<Distances> distancesAt(const RenderSettings& settings) {
  std::vector<image::Image> ours;
  image::Image background;
  {
    Renderer renderer(settings, clothCovers());  // One context at a time.
    background = testing::emptyPicture(renderer);
    for (const auto& corners : sideViews()) ours.push_back(testing::drawn(renderer, corners));
  }
  std::vector<Distances> all;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const body::Cage corners = sideViews()[i];
    const image::Image reference = testing::meanLight(samplesOf(settings, corners), background);
    const image::Image four =
        testing::meanLight(SampledBook(settings, clothCovers()).multisampled(corners), background);
    all.push_back({distanceOf(ours[i], reference), distanceOf(four, reference)});
  }
  return all;
}

// Of four samples, in brackets.
constexpr int kFewFar = 15;        // measured up to 10 (318)
constexpr double kGoodBlock = 10;  // measured up to 8.7 (20.6)

void expectNowhereFarther(const std::vector<Distances>& all) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& [ours, theirs] = all[i];
    SCOPED_TRACE("view " + std::to_string(i));
    EXPECT_LT(ours.largest, theirs.largest);      // measured 22 to 49, and 86 to 107
    EXPECT_LT(ours.brightest, theirs.brightest);  // measured 18 to 49, and 86 to 107
    EXPECT_LT(ours.farPixels, std::min(theirs.farPixels, kFewFar));
    EXPECT_LT(ours.block, std::min(theirs.block, kGoodBlock));
  }
}

TEST(Multisampling, IsNowhereCloserTo64SamplesAt640x360) {
  expectNowhereFarther(distancesAt(asInFigures(640, 360, 86, 30)));
}

TEST(Multisampling, IsNowhereCloserTo64SamplesInOneOfFourPanels) {
  expectNowhereFarther(distancesAt(asInFigures(158, 274, 78, 36.7729)));
}

}  // namespace
}  // namespace rotatebook::render
