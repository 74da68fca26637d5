// Drawing is confined to Projection::bands: they must hold all that the book touches.
#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/camera.h"
#include "render/drawing.h"

namespace rotatebook::render {
namespace {

using testing::book;
using testing::builtinTextures;
using testing::colourAt;
using testing::drawn;
using testing::emptyPicture;
using testing::kX;
using testing::kY;
using testing::kZ;
using testing::settingsOf;

constexpr int kBoundsWidth = 160;
constexpr int kBoundsHeight = 90;

std::vector<body::Cage> shapes() {
  std::vector<body::Cage> result = {book(), testing::skewedBook(), testing::insideOutBook()};
  for (int i = 0; i < 24; ++i) {
    result.push_back(book({{37.0 * i, kX}, {53.0 * i, kY}, {71.0 * i, kZ}}));
  }
  // Thin, large, off the middle and half out of the picture.
  result.push_back(2.5 * book({{30, kY}, {40, kX}}));
  result.push_back(book({{89, kY}, {3, kX}}).colwise() + Eigen::Vector3d(0.2, 0.1, 0.2));
  result.push_back(testing::skewedBook().colwise() + Eigen::Vector3d(-0.4, -0.1, 0.1));
  return result;
}

bool inside(const geometry::PixelRect& area, int x, int y) {
  return x >= area.x && x < area.x + area.width && y >= area.y && y < area.y + area.height;
}

bool inside(const std::vector<geometry::PixelRect>& areas, int x, int y) {
  return std::ranges::any_of(areas,
                             [&](const geometry::PixelRect& area) { return inside(area, x, y); });
}

/// Returns whether the pixel and those beside it within the picture are all in the areas.
bool wellInside(const std::vector<geometry::PixelRect>& areas, int x, int y) {
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const int column = std::clamp(x + dx, 0, kBoundsWidth - 1),
                row = std::clamp(y + dy, 0, kBoundsHeight - 1);
      if (!inside(areas, column, row)) return false;
    }
  }
  return true;
}

// Nothing is drawn outside the bounds by construction; that nothing is cut off shows in their rim,
// which no part of the book reaches.
TEST(Bounds, LeaveARimThatTheBookDoesNotTouch) {
  Renderer renderer(settingsOf(kBoundsWidth, kBoundsHeight), builtinTextures());
  const image::Image background = emptyPicture(renderer);
  const std::vector<body::Cage> all = shapes();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const image::Image picture = drawn(renderer, all[i]);
    const auto camera = settingsOf(kBoundsWidth, kBoundsHeight).camera;
    const auto bands = geometry::project(camera, all[i], {kBoundsWidth, kBoundsHeight}).bands;
    int touched = 0;
    for (int y = 0; y < kBoundsHeight; ++y) {
      for (int x = 0; x < kBoundsWidth; ++x) {
        const bool same = colourAt(picture, x, y) == colourAt(background, x, y);
        ASSERT_TRUE(same || wellInside(bands, x, y)) << "shape " << i << " at " << x << "," << y;
        touched += same ? 0 : 1;
      }
    }
    EXPECT_GT(touched, 100) << "shape " << i << " is hardly there";
  }
}

TEST(Bounds, AreTight) {
  Renderer renderer(settingsOf(kBoundsWidth, kBoundsHeight), builtinTextures());
  const image::Image background = emptyPicture(renderer);
  const image::Image picture = drawn(renderer, book());
  const auto bounds = geometry::project(settingsOf(kBoundsWidth, kBoundsHeight).camera, book(),
                                        {kBoundsWidth, kBoundsHeight})
                          .bounds;
  constexpr int kSlack = 8;  // Of the margin and rounding. measured 7
  int left = kBoundsWidth, right = 0, top = kBoundsHeight, bottom = 0;
  for (int y = 0; y < kBoundsHeight; ++y) {
    for (int x = 0; x < kBoundsWidth; ++x) {
      if (colourAt(picture, x, y) == colourAt(background, x, y)) continue;
      left = std::min(left, x), right = std::max(right, x);
      top = std::min(top, y), bottom = std::max(bottom, y);
    }
  }
  EXPECT_LE(left - bounds.x, kSlack);
  EXPECT_LE(top - bounds.y, kSlack);
  EXPECT_LE(bounds.x + bounds.width - 1 - right, kSlack);
  EXPECT_LE(bounds.y + bounds.height - 1 - bottom, kSlack);
}

// Of a slanting book the bounds are half empty.
TEST(Bands, LeaveOutMostOfWhatIsBesideTheHull) {
  const geometry::Camera camera = settingsOf(1280, 720).camera;
  const auto projection = geometry::project(camera, book({{45, kZ}}), {1280, 720});
  const auto area = [](const geometry::PixelRect& rect) { return rect.width * rect.height; };
  int banded = 0;
  for (const geometry::PixelRect& band : projection.bands) banded += area(band);
  const double share = static_cast<double>(banded) / area(projection.bounds);
  EXPECT_LT(share, 0.6);  // measured 0.54
  EXPECT_GT(share, 0.45);
}

TEST(Bands, StandOneBelowTheOtherWithinTheBounds) {
  for (const body::Cage& corners : shapes()) {
    const auto projection = geometry::project(settingsOf(kBoundsWidth, kBoundsHeight).camera,
                                              corners, {kBoundsWidth, kBoundsHeight});
    int row = projection.bounds.y;
    for (const geometry::PixelRect& band : projection.bands) {
      EXPECT_GE(band.y, row);
      EXPECT_GE(band.x, projection.bounds.x);
      EXPECT_LE(band.x + band.width, projection.bounds.x + projection.bounds.width);
      row = band.y + band.height;
    }
    EXPECT_LE(row, projection.bounds.y + projection.bounds.height);
  }
}

// The background inside the bands is drawn anew, outside it is copied: both must be the same.
TEST(Bounds, DoNotShowInTheBackground) {
  Renderer renderer(settingsOf(kBoundsWidth, kBoundsHeight), builtinTextures());
  const image::Image background = emptyPicture(renderer);
  body::Cage speck = 1e-6 * book();
  speck.col(0) = Eigen::Vector3d(0.3, 0.2, 0);  // A needle: wide bounds, next to no pixels.
  const image::Image picture = drawn(renderer, speck);
  int differing = 0;
  for (int y = 0; y < kBoundsHeight; ++y) {
    for (int x = 0; x < kBoundsWidth; ++x) {
      differing += colourAt(picture, x, y) == colourAt(background, x, y) ? 0 : 1;
    }
  }
  EXPECT_LT(differing, kBoundsWidth);
}

TEST(Bounds, BesideThePictureLeaveTheBackground) {
  Renderer renderer(settingsOf(kBoundsWidth, kBoundsHeight), builtinTextures());
  const image::Image right = emptyPicture(renderer);
  drawn(renderer, book());
  const body::Cage above = book().colwise() + Eigen::Vector3d(0, 20, 0);
  EXPECT_EQ(drawn(renderer, above), right);
}

}  // namespace
}  // namespace rotatebook::render
