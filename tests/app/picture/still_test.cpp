#include "picture/still.h"

#include <cmath>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "image/png_file.h"
#include "messages.h"
#include "picture/attitudes.h"
#include "pipeline/small_clip.h"

namespace rotatebook::picture {
namespace {

namespace fs = std::filesystem;
using pipeline::testing::smallScene;

TEST(Still, IsTheClipsFrameNearestToTheTime) {
  const fs::path folder = pipeline::testing::emptyFolder();
  pipeline::testing::render(smallScene(), {.folder = folder, .outputs = {pipeline::pngOutput()}});
  const auto still = [&](double frames) {
    return renderStill(smallScene(), frames / 24, folder / "still.png");
  };
  for (const auto& [time, frame] :
       {std::pair{0.0, 0}, {5.0, 5}, {5.4, 5}, {5.6, 6}, {11.0, 11}, {12.0, 11}}) {
    EXPECT_EQ(still(time), frame) << time;
    EXPECT_EQ(image::readPng(folder / "still.png"),
              image::readPng(folder / "small" / store::frameName(frame)))
        << time;
  }
}

TEST(Still, MustBeInTheClip) {
  const fs::path path = pipeline::testing::emptyFolder() / "still.png";
  for (const double time : {-0.1, 0.51, std::nan("")}) {
    EXPECT_MESSAGE(
        pipeline::testing::messageOf<InputError>([&] { renderStill(smallScene(), time, path); }));
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST(Still, MayBeInTheSecondAfterTheMotionDiverges) {
  const fs::path path = pipeline::testing::emptyFolder() / "still.png";
  const auto still = [&](double time) {
    return renderStill(pipeline::testing::divergingScene(), time, path);
  };
  EXPECT_EQ(still(28.0 / 24), 28);
  fs::remove(path);
  EXPECT_EQ(pipeline::testing::messageOf<InputError>([&] { still(1.25); }),
            "there is no picture at 1.25 s: the clip lasts from 0 to 1.2083333333333333 s, a "
            "second after its motion diverges");
  EXPECT_FALSE(fs::exists(path));
}

bool touches(const scene::Scene& scene, int margin) {
  return testing::anyAttitudeTouchesBorder(scene, {scene.clip.width, scene.clip.height, 0}, margin);
}

TEST(DefaultCamera, ShowsAllOfTheBookInAnyAttitude) {
  for (const char* size : {"clip.size=[128,72]", "clip.size=[72,128]", "clip.size=[96,96]"}) {
    EXPECT_FALSE(touches(smallScene({size}), 1)) << size;
    EXPECT_TRUE(touches(smallScene({size}), 12)) << size << " shows it small";
  }
}

}  // namespace
}  // namespace rotatebook::picture
