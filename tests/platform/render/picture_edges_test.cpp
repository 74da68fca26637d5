// Edges and colours of single pixels.
#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "render/drawing.h"

namespace rotatebook::render {
namespace {

using testing::book;
using testing::Colour;
using testing::colourAt;
using testing::drawn;
using testing::plain;

constexpr int kCutWidth = 128;
constexpr int kCutHeight = 72;

double linear(int encoded) {
  const double value = encoded / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

double encoded(double value) {
  return 255 * (value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055);
}

BookTextures white() {
  const Colour kWhite{250, 250, 250};
  return {plain(8, 8, kWhite), plain(8, 8, kWhite), plain(8, 8, kWhite)};
}

/// A pixel that the book's right edge crosses, and its neighbours.
struct EdgePixel {
  int outside;
  int value;
  int inside;
};

// The green of the edge pixel in the middle row, for books at 16 parts of a pixel.
std::vector<EdgePixel> edgePixels() {
  Renderer renderer(testing::settingsOf(kCutWidth, kCutHeight), white());
  const image::Image background = testing::emptyPicture(renderer);
  std::vector<EdgePixel> edges;
  for (int step = 0; step < 16; ++step) {
    constexpr double kPixel = 0.0065;  // m, at the front cover
    const body::Cage corners = book().colwise() + Eigen::Vector3d(step * kPixel / 16, 0, 0);
    const image::Image picture = drawn(renderer, corners);
    const int y = kCutHeight / 2;
    int x = kCutWidth - 1;
    while (colourAt(picture, x, y) == colourAt(background, x, y)) --x;
    edges.push_back({colourAt(picture, x + 1, y).green, colourAt(picture, x, y).green,
                     colourAt(picture, x - 1, y).green});
  }
  return edges;
}

// The share of the book in `edge` if light adds up, in sixteenths.
double sixteenths(const EdgePixel& edge) {
  return 16 * (linear(edge.value) - linear(edge.outside)) /
         (linear(edge.inside) - linear(edge.outside));
}

// The pixel's columns of samples are crossed one after the other.
TEST(PictureEdges, AreMixedInLinearLightBySixteenths) {
  constexpr double kBound = 0.3;  // sixteenths; measured 0.00
  std::set<int> seen;
  for (const EdgePixel& edge : edgePixels()) {
    EXPECT_NEAR(sixteenths(edge), std::round(sixteenths(edge)), kBound);
    seen.insert(static_cast<int>(std::lround(sixteenths(edge))));
  }
  EXPECT_GE(seen.size(), 15U);
}

// Half the light of white on dark is far from half the number.
TEST(PictureEdges, AreNotMixedByTheirNumbers) {
  int halves = 0;
  for (const EdgePixel& edge : edgePixels()) {
    if (std::lround(sixteenths(edge)) != 8) continue;
    ++halves;
    const double byLight = encoded((linear(edge.inside) + linear(edge.outside)) / 2);
    EXPECT_NEAR(edge.value, byLight, 3);  // The edge is rounded, and shaded so. measured 2.6
    EXPECT_GT(edge.value, (edge.inside + edge.outside) / 2 + 15);
  }
  EXPECT_GT(halves, 0);
}

// A texture's number goes through linear light and back: a middle grey that is lit half as bright
// as white must not come out as half the number.
TEST(PictureColours, AreLitInLinearLight) {
  const auto middle = [](int grey) {
    const Colour colour{grey, grey, grey};
    Renderer renderer(testing::settingsOf(kCutWidth, kCutHeight),
                      {plain(8, 8, colour), plain(8, 8, colour), plain(8, 8, colour)});
    return colourAt(drawn(renderer, book()), kCutWidth / 2, kCutHeight / 2).green;
  };
  constexpr double kBound = 0.1;  // measured 0.044
  // Dark enough that highlights are hardly compressed, and so much that the shine is small.
  const double ratio =
      (linear(middle(100)) - linear(middle(0))) / (linear(middle(60)) - linear(middle(0)));
  EXPECT_NEAR(ratio / (linear(100) / linear(60)), 1, kBound);
}

}  // namespace
}  // namespace rotatebook::render
