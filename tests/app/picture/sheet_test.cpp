#include "picture/sheet.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "image/image.h"
#include "picture/frame_drawer.h"
#include "pipeline/small_clip.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::picture {
namespace {

using pipeline::testing::smallScene;

/// Returns whether `sheet` shows `frame` of `scene` with its top left at (x, y).
bool shows(const image::Image& sheet, int x, int y, const scene::Scene& scene, std::int64_t frame) {
  const timeline::ClipMotion motion = timeline::simulateScene(scene);
  FrameDrawer drawer(scene, motion);
  image::Image wanted = drawer.makePicture();
  drawer.draw(frame, wanted);
  for (int row = 0; row < wanted.height(); ++row) {
    const std::uint8_t* here = sheet.row(y + row) + x * bytesPerPixel(sheet.format());
    if (!std::equal(wanted.row(row), wanted.row(row) + wanted.stride(), here)) return false;
  }
  return true;
}

/// Pixels of a rectangle that are brighter than the background.
int lettersIn(const image::Image& sheet, int x, int y, int width, int height) {
  int count = 0;
  for (int row = y; row < y + height; ++row) {
    for (int column = x; column < x + width; ++column) {
      count += sheet.row(row)[column * bytesPerPixel(sheet.format())] > 100 ? 1 : 0;
    }
  }
  return count;
}

// 64x36 pictures with gaps of 4.
TEST(Sheet, ShowsFramesFromTheFirstToTheLastWithTheirTimes) {
  const scene::Scene scene = smallScene();
  const image::Image sheet = drawSheet({scene}, {.count = 4});
  EXPECT_EQ(sheet.width(), 2 * 68 + 4);
  const int step = (sheet.height() - 4) / 2;
  EXPECT_TRUE(shows(sheet, 4, 4, scene, 0));
  EXPECT_TRUE(shows(sheet, 72, 4, scene, 4));
  EXPECT_TRUE(shows(sheet, 4, 4 + step, scene, 7));
  EXPECT_TRUE(shows(sheet, 72, 4 + step, scene, 11));
  EXPECT_FALSE(shows(sheet, 72, 4 + step, scene, 10));
  EXPECT_GT(lettersIn(sheet, 4, 41, 64, step - 41), 10);
}

TEST(Sheet, HasTheDecimalMarkOfItsScene) {
  const auto sheetIn = [](const char* words) {
    return drawSheet({smallScene({std::string("overlay.words=") + words})}, {.count = 2});
  };
  EXPECT_TRUE(sheetIn("english") == sheetIn("{ Energy = 'E' }"));
  EXPECT_FALSE(sheetIn("english") == sheetIn("{ decimal_mark = ',' }"));
}

// Inter has no mark of Arabic, nor letters of Hebrew.
TEST(Sheet, HasTheFontOfItsScene) {
  const auto sheetIn = [](const std::vector<std::string>& more) {
    std::vector<scene::Scene> scenes{smallScene(more), smallScene(more)};
    for (scene::Scene& scene : scenes) scene.title = "\u05e9\u05dc\u05d5\u05dd";
    return drawSheet(scenes, {.count = 2});
  };
  const std::string mark = "overlay.words={ decimal_mark = '\u066b' }";
  const image::Image sheet = sheetIn({"overlay.font='DejaVu Sans'", mark});
  EXPECT_FALSE(sheet == sheetIn({"overlay.font='DejaVu Sans'"}));
  EXPECT_THROW(sheetIn({mark}), InputError);
}

TEST(Sheet, ShowsTheTimesThatAreAskedFor) {
  const scene::Scene scene = smallScene();
  const image::Image sheet = drawSheet({scene}, {.times = {0.25, 0.125}, .columns = 1});
  EXPECT_EQ(sheet.width(), 72);
  EXPECT_TRUE(shows(sheet, 4, 4, scene, 6));
  EXPECT_TRUE(shows(sheet, 4, 4 + (sheet.height() - 4) / 2, scene, 3));
}

// As long as both are the same, the motion's time isn't said.
TEST(Sheet, SaysTheTimeOfTheVideoAndInSlowMotionTheOthersToo) {
  const auto letters = [](const std::string& speed) {
    const scene::Scene scene = smallScene({"clip.size=[192, 108]", "clip.speed=" + speed});
    const image::Image sheet = drawSheet({scene}, {.times = {0.25}});
    const int below = 6 + 108;
    return lettersIn(sheet, 6, below, 192, sheet.height() - below);
  };
  EXPECT_GT(letters("0.5"), letters("1") + 100);  // measured 261 and 112
}

TEST(Sheet, ShowsThePosterOfEachScene) {
  const scene::Scene a = smallScene({"clip.poster=0.125"});
  const scene::Scene b = smallScene({"initial.angular_velocity=[0, 9, 0]"});
  const image::Image sheet = drawSheet({a, b}, {.count = 1});
  EXPECT_TRUE(shows(sheet, 4, 4, a, 3));
  EXPECT_TRUE(shows(sheet, 72, 4, b, 6));
}

TEST(Sheet, RefusesWhatItCanNotShow) {
  const auto messageOf = [](const std::vector<scene::Scene>& scenes, const SheetOptions& options) {
    return pipeline::testing::messageOf<InputError>([&] { drawSheet(scenes, options); });
  };
  EXPECT_EQ(messageOf({smallScene(), smallScene({"clip.size=[64, 38]"})}, {}),
            "small differs in size from small; set one size for all, for example --size 480x270");
  EXPECT_EQ(messageOf({smallScene()}, {.times = {7}}),
            "there is no picture at 7 s: the clip lasts from 0 to 0.5 s");
  EXPECT_EQ(
      messageOf({smallScene()}, {.count = 300, .columns = 300}),
      "the sheet would have 20404x59 pixels, but a side may have at most 16384; take fewer or "
      "smaller pictures, for example --size 480x270");
}

}  // namespace
}  // namespace rotatebook::picture
