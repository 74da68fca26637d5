#include "picture/thumbnail.h"

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/small_clip.h"

namespace rotatebook::picture {
namespace {

using pipeline::testing::smallScene;

std::pair<int, int> sizeOf(const std::string& clipSize) {
  const scene::Scene small = thumbnailScene(smallScene({"clip.size=" + clipSize}));
  return {small.clip.width, small.clip.height};
}

TEST(Thumbnail, KeepsTheShapeOfItsClip) {
  EXPECT_EQ(sizeOf("[1280, 720]"), std::pair(480, 270));
  EXPECT_EQ(sizeOf("[1920, 1080]"), std::pair(480, 270));
  EXPECT_EQ(sizeOf("[1080, 1350]"), std::pair(480, 600));
  EXPECT_EQ(sizeOf("[64, 36]"), std::pair(64, 36));
  EXPECT_EQ(sizeOf("[4000, 200]"), std::pair(1920, 96));
}

TEST(Thumbnail, ShowsThePosterWithoutWords) {
  const std::string size = "clip.size=[320, 180]", poster = "clip.poster=0.25";
  const image::Image plain = drawThumbnail(smallScene({size, poster}));
  const std::vector<std::string> overrides{
      size, poster, "caption=Words",
      "overlay.show=['caption', 'clock', 'half_turns', 'energy', 'polhode']"};
  EXPECT_EQ(drawThumbnail(smallScene(overrides)), plain);
  EXPECT_NE(drawThumbnail(smallScene({size, "clip.poster=0.5"})), plain);
  EXPECT_NE(drawThumbnail(smallScene({size, poster, "overlay.show=['omega']"})), plain);
}

TEST(Thumbnail, LeavesOutThePanelsLabels) {
  const auto drawn = [](const std::string& label) {
    return drawThumbnail(
        scene::parseScene("[clip]\nsize = [320, 180]\nfps = 24\nduration = 0.5\n"
                          "[initial]\nangular_velocity = [5, 3, 1]\n"
                          "[[panel]]\nlabel = \"" +
                              label + "\"\n[[panel]]\nlabel = \"other\"\n",
                          "pair.toml"));
  };
  EXPECT_EQ(drawn("a"), drawn("quite another label"));
}

TEST(Thumbnail, KeepsItsAlpha) {
  const image::Image picture = drawThumbnail(smallScene({"look.background='transparent'"}));
  EXPECT_EQ(picture.row(0)[3], 0);
  EXPECT_EQ(picture.row(picture.height() / 2)[4 * (picture.width() / 2) + 3], 255);
}

}  // namespace
}  // namespace rotatebook::picture
