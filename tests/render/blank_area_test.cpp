#include "render/blank_area.h"

#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace rotatebook::render {
namespace {

// A gradient, as a background is, with one colour inside `area`.
image::Image pictureWithHole(const PixelRect& area) {
  image::Image picture(200, 150, image::PixelFormat::Rgba8);
  for (int y = 0; y < 150; ++y) {
    for (int x = 0; x < 200; ++x) {
      const bool inside =
          x >= area.x && x < area.x + area.width && y >= area.y && y < area.y + area.height;
      picture.row(y)[4 * x] = inside ? 7 : static_cast<std::uint8_t>(x);
      picture.row(y)[4 * x + 1] = inside ? 7 : static_cast<std::uint8_t>(y);
    }
  }
  return picture;
}

constexpr PixelRect kArea{20, 30, 100, 80};
const std::vector<PixelRect> kBands{{20, 30, 100, 50}, {20, 80, 100, 30}};

TEST(BlankArea, IsSeenWithinAPicture) {
  EXPECT_TRUE(isBlank(pictureWithHole(kArea), kBands));
}

TEST(BlankArea, IsNotOneWithASinglePixelInIt) {
  for (const auto& [x, y] : {std::pair{20, 30}, {119, 30}, {20, 109}, {119, 109}, {70, 60}}) {
    image::Image picture = pictureWithHole(kArea);
    picture.row(y)[4 * x + 2] = 1;
    EXPECT_FALSE(isBlank(picture, kBands)) << x << ", " << y;
  }
}

TEST(BlankArea, IsNeverSmall) {
  const PixelRect small{20, 30, 63, 80};
  EXPECT_FALSE(isBlank(pictureWithHole(kArea), {small}));
  EXPECT_FALSE(isBlank(pictureWithHole(kArea), {}));
}

}  // namespace
}  // namespace rotatebook::render
