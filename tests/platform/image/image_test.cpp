#include "image/image.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "image/marked_tiles.h"
#include "image/moving_picture.h"

namespace rotatebook::image {
namespace {

TEST(Image, StartsBlackAndTransparent) {
  const Image picture(2, 3, PixelFormat::Rgba8);
  EXPECT_EQ(picture.stride(), 8);
  for (int y = 0; y < 3; ++y) {
    for (int i = 0; i < 8; ++i) EXPECT_EQ(picture.row(y)[i], 0);
  }
}

TEST(Image, HasRowsWithoutPadding) {
  Image picture(5, 2, PixelFormat::Rgb8);
  EXPECT_EQ(picture.stride(), 15);
  EXPECT_EQ(picture.row(1) - picture.row(0), 15);
}

TEST(Image, TakesAPieceOfAnother) {
  Image picture(4, 3, PixelFormat::Rgba8), piece(2, 2, PixelFormat::Rgba8);
  for (int y = 0; y < 2; ++y) {
    for (int i = 0; i < 8; ++i) piece.row(y)[i] = static_cast<std::uint8_t>(10 * y + i + 1);
  }
  paste(piece.view(), 2, 1, picture);
  for (int y = 0; y < 3; ++y) {
    for (int i = 0; i < 16; ++i) {
      const bool covered = y >= 1 && i >= 8;
      EXPECT_EQ(picture.row(y)[i], covered ? 10 * (y - 1) + i - 8 + 1 : 0) << i << ", " << y;
    }
  }
}

TEST(Image, IsAValue) {
  Image original(1, 1, PixelFormat::Rgb8);
  const Image copy = original;
  EXPECT_EQ(copy, original);
  original.row(0)[2] = 9;
  EXPECT_NE(copy, original);
  EXPECT_NE(copy, Image(1, 1, PixelFormat::Rgba8));
}

TEST(Image, ShowsTheGroundAroundWhatWasTouchedAndTheRestElsewhere) {
  testing::MovingPicture moving(200, 50);
  for (const Area& patch : testing::kPatches) {
    const Image& picture = moving.with(patch);
    Tiles(200, 50).forEach(picture.area(), [&](std::size_t, const Area& tile) {
      const Image& behind = common(patch, tile).empty() ? moving.rest() : moving.ground();
      for (int y = tile.y; y < tile.bottom(); ++y) {
        for (int x = tile.x; x < tile.right(); ++x) {
          const bool isCovered = !common(patch, {x, y, 1, 1}).empty();
          EXPECT_TRUE(isCovered || std::equal(behind.row(y) + 4 * x, behind.row(y) + 4 * x + 4,
                                              picture.row(y) + 4 * x))
              << x << ", " << y;
        }
      }
    });
  }
}

TEST(Image, HasEqualMarksForEqualTilesAlone) {
  testing::MovingPicture moving(200, 50);
  testing::MarkedTiles tiles;
  for (const Area& patch : testing::kPatches) {
    Image picture = moving.with(patch);
    paste(Image(1, 1, PixelFormat::Rgba8).view(), 150, 20, picture);  // Also after settle()
    EXPECT_TRUE(tiles.agreeWith(picture)) << patch.x;
  }
  EXPECT_GE(tiles.known(), 90U);  // measured 98 of 144
}

TEST(Image, HasNoMarksUnlessItIsDrawnOverAGround) {
  Image picture(200, 50, PixelFormat::Rgba8);
  picture.touch(picture.area());
  EXPECT_EQ(picture.view().marks, nullptr);
}

TEST(Image, LosesItsMarksWhereItsRowsMayBeWritten) {
  testing::MovingPicture moving(200, 50);
  Image picture = moving.with({5, 3, 20, 9});
  EXPECT_NE(picture.view().marks, nullptr);
  picture.row(7)[3] = 77;
  EXPECT_EQ(picture.view().marks, nullptr);
}

TEST(ImageView, SeesWhatTheImageHolds) {
  Image picture(2, 2, PixelFormat::Rgb8);
  picture.row(1)[3] = 77;
  const ImageView view = picture.view();
  EXPECT_EQ(view.width, 2);
  EXPECT_EQ(view.height, 2);
  EXPECT_EQ(view.format, PixelFormat::Rgb8);
  EXPECT_EQ(view.row(1)[3], 77);
}

TEST(ImageView, TurnsBottomUpMemoryOver) {
  const std::vector<std::uint8_t> bottomRowFirst = {7, 7, 7, 8, 8, 8, 9, 9, 9};
  const ImageView view{bottomRowFirst.data() + 6, 1, 3, -3, PixelFormat::Rgb8};
  EXPECT_EQ(view.row(0)[0], 9);
  EXPECT_EQ(view.row(1)[0], 8);
  EXPECT_EQ(view.row(2)[0], 7);
}

}  // namespace
}  // namespace rotatebook::image
