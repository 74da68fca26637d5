#include "render/antialias/strips.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "render/body/mesh_geometry.h"
#include "render/drawing.h"

namespace rotatebook::render {
namespace {

using testing::book;
using testing::kX;
using testing::kY;

std::vector<ScreenStrip> stripsAt(int width, int height, const body::Cage& corners) {
  const geometry::Projection projection =
      geometry::project(testing::settingsOf(width, height).camera, corners, {width, height, 0});
  std::vector<ScreenStrip> onScreen;
  StripFinder(geometry::makeBookMesh())
      .find(corners, projection.clipFromWorld, frontFaceWinding(corners), {width, height},
            onScreen);
  return onScreen;
}

long narrowAt(int width, int height, const body::Cage& corners) {
  return std::ranges::count_if(stripsAt(width, height, corners), &ScreenStrip::narrow);
}

TEST(Strips, AreNarrowInSmallPicturesAlone) {
  const body::Cage corners = book({{-35, kY}, {20, kX}});
  EXPECT_GE(narrowAt(320, 180, corners), 30);   // measured 38
  EXPECT_LE(narrowAt(7680, 4320, corners), 4);  // measured 2
}

TEST(Strips, AreNotNarrowBehindTheCamera) {
  EXPECT_EQ(narrowAt(320, 180, testing::explodingBook()), 0);
}

TEST(Strips, AreFollowedInPerspective) {
  ScreenStrip strip{.narrow = true, .from = {10, 5}, .direction = {0.01F, 0}, .distances = {1, 3}};
  EXPECT_FLOAT_EQ(strip.shareAt({10, 5}), 0);
  EXPECT_FLOAT_EQ(strip.shareAt({110, 7}), 1);
  EXPECT_FLOAT_EQ(strip.shareAt({60, 5}), 0.25F);  // The farther half takes less of the picture.
  EXPECT_FLOAT_EQ(strip.shareAt({-50, 5}), 0);
}

// Each row is drawn from end to end, and nothing of it is black.
TEST(Strips, HaveColoursThroughout) {
  Renderer renderer(testing::settingsOf(320, 180), testing::builtinTextures());
  DrawnBody drawn = renderer.makeBody();
  for (const double angle : {0.0, 40.0, 90.0, 170.0, 270.0}) {
    renderer.draw(book({{angle, kY}, {20, kX}}), drawn);
    const std::vector<ScreenStrip>& onScreen = drawn.strips.onScreen;
    for (std::size_t i = 0; i < onScreen.size(); ++i) {
      if (!onScreen[i].narrow) continue;
      const std::uint8_t* row = drawn.strips.colours.row(static_cast<int>(i));
      for (int x = 0; x < static_cast<int>(onScreen[i].columns); ++x) {
        EXPECT_GT(row[4 * x], 20) << "strip " << i << ", column " << x;  // measured 61
        EXPECT_NE(row[4 * x + 3], 0) << "strip " << i << ", column " << x;
      }
    }
  }
}

}  // namespace
}  // namespace rotatebook::render
