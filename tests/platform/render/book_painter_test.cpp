#include "render/body/book_painter.h"

#include <algorithm>
#include <cstdint>

#include <gtest/gtest.h>

#include "render/body/mesh_geometry.h"
#include "render/body/test_pattern.h"
#include "render/device/egl_context.h"
#include "render/drawing.h"
#include "render/gl/frame_target.h"

namespace rotatebook::render {
namespace {

// A test frame is to tell processors and drivers that compute gold otherwise, too.
TEST(BookPainter, TestsCoversAsItDrawsThem) {
  const EglContext context(DeviceChoice{});
  const BookPainter painter({testPattern(), testPattern(), testPattern()}, {});
  const geometry::PixelRect all{0, 0, 192, 108};
  const FrameTarget target(all.width, all.height);
  const geometry::Camera camera{.position = {0, 0, 0.62}};
  DrawnBody body{.pixels = {}, .cage = testing::book()};
  body.clipFromWorld = geometry::project(camera, body.cage, {192, 108, 0}).clipFromWorld;
  body.winding = frontFaceWinding(body.cage);
  const PlacedBody placed{&body, camera.position, all};
  const auto drawnBy = [&](const auto& draw) {
    image::Image picture(all.width, all.height, image::PixelFormat::Rgba8);
    target.begin(all);
    draw();
    target.readBack({&all, 1}, picture);
    return picture;
  };
  const image::Image tested = drawnBy([&] { painter.drawTest(placed); });
  const image::Image drawn = drawnBy([&] { painter.draw({&placed, 1}); });
  int covered = 0, other = 0;
  for (int y = 0; y < all.height; ++y) {
    for (int x = 0; x < all.width; ++x) {
      const std::uint8_t *one = tested.row(y) + 4 * x, *two = drawn.row(y) + 4 * x;
      EXPECT_EQ(one[3], two[3]);
      if (one[3] == 0) continue;
      ++covered;
      if (!std::equal(one, one + 3, two)) ++other;
    }
  }
  EXPECT_GT(covered, 6000);  // measured 6174
  EXPECT_LT(other, 300);     // measured 208, where the pattern repeats
}

}  // namespace
}  // namespace rotatebook::render
