#include "render/antialias/edge_pixels.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace rotatebook::render {
namespace {

using Place = std::pair<int, int>;

std::vector<Place> pixelsOf(const EdgePixels& pixels, int left, int right) {
  std::vector<Place> all;
  for (int y = 0; y < pixels.height(); ++y) {
    pixels.forEach(y, left, right, [&](int x, std::size_t) { all.emplace_back(x, y); });
  }
  return all;
}

/// The pixels that a line touches, found at many of its points.
std::set<Place> touched(const Eigen::Vector2f& from, const Eigen::Vector2f& to, int width,
                        int height) {
  constexpr int kPoints = 20'000;
  std::set<Place> all;
  for (int i = 0; i <= kPoints; ++i) {
    const Eigen::Vector2f place = from + (to - from) * (static_cast<float>(i) / kPoints);
    // In pixels' corners and on their borders either will do.
    const Eigen::Array2f offset = place.array() - place.array().round();
    if (offset.abs().minCoeff() < 1e-3F) continue;
    const Place pixel{static_cast<int>(std::floor(place.x())),
                      static_cast<int>(std::floor(place.y()))};
    if (pixel.first >= 0 && pixel.first < width && pixel.second >= 0 && pixel.second < height) {
      all.insert(pixel);
    }
  }
  return all;
}

TEST(EdgePixels, AreThoseThatALineTouches) {
  const std::vector<std::pair<Eigen::Vector2f, Eigen::Vector2f>> lines{
      {{3.2F, 4.1F}, {190.7F, 60.3F}}, {{190.7F, 60.3F}, {3.2F, 4.1F}},
      {{20.5F, 70}, {33.1F, 2.5F}},    {{5.5F, 5.5F}, {5.6F, 5.6F}},
      {{-40, 30.2F}, {300, 45.9F}},    {{60.3F, -50}, {61, 200}},
      {{10, 20.5F}, {150, 20.5F}},     {{100.5F, 10.5F}, {100.5F, 60.5F}}};
  for (const auto& [from, to] : lines) {
    EdgePixels pixels(200, 80);
    pixels.addLine(from, to);
    pixels.number();
    const std::vector<Place> all = pixelsOf(pixels, 0, 200);
    const std::set<Place> expected = touched(from, to, 200, 80);
    for (const Place& pixel : expected) {
      EXPECT_NE(std::ranges::find(all, pixel), all.end()) << pixel.first << " " << pixel.second;
    }
    // A corner that the line only just misses may be among them.
    EXPECT_LE(all.size(), expected.size() + 3);
  }
}

TEST(EdgePixels, AreNumberedRowByRow) {
  EdgePixels pixels(200, 80);
  pixels.addLine({3.2F, 4.1F}, {190.7F, 60.3F});
  pixels.addLine({20.5F, 70}, {33.1F, 2.5F});
  pixels.number();
  std::size_t next = 0;
  for (int y = 0; y < 80; ++y) {
    pixels.forEach(y, 0, 200, [&](int, std::size_t number) { EXPECT_EQ(number, next++); });
  }
  EXPECT_EQ(pixels.count(), next);
  EXPECT_GT(next, 200U);
}

TEST(EdgePixels, KeepTheirNumbersInPartsOfARow) {
  EdgePixels pixels(200, 10);
  pixels.addLine({1, 3.5F}, {199, 5.5F});
  pixels.number();
  for (int y = 0; y < 10; ++y) {
    std::vector<std::pair<int, std::size_t>> whole;
    pixels.forEach(y, 0, 200, [&](int x, std::size_t number) { whole.emplace_back(x, number); });
    for (const auto& [left, right] : {Place{0, 64}, {63, 129}, {64, 128}, {70, 71}, {90, 90}}) {
      std::vector<std::pair<int, std::size_t>> part, expected;
      pixels.forEach(y, left, right,
                     [&](int x, std::size_t number) { part.emplace_back(x, number); });
      for (const auto& one : whole) {
        if (one.first >= left && one.first < right) expected.push_back(one);
      }
      EXPECT_EQ(part, expected) << "row " << y << " from " << left << " to " << right;
    }
  }
}

TEST(EdgePixels, CanBeClearedForTheNextPicture) {
  EdgePixels pixels(20, 10);
  pixels.addLine({1, 3.5F}, {19, 5.5F});
  pixels.clear();
  pixels.number();
  EXPECT_EQ(pixels.count(), 0U);
  EXPECT_TRUE(pixelsOf(pixels, 0, 20).empty());
}

}  // namespace
}  // namespace rotatebook::render
