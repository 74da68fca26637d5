#include "pipeline/still.h"

#include <cmath>
#include <filesystem>
#include <string>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "image/png_file.h"
#include "pipeline/small_clip.h"

namespace rotatebook::pipeline {
namespace {

namespace fs = std::filesystem;
using testing::bytesOf;
using ::testing::HasSubstr;
using testing::smallScene;

TEST(Still, IsTheClipsFrameNearestToTheTime) {
  const fs::path folder = testing::emptyFolder();
  testing::render(smallScene(), {.folder = folder, .mp4 = false});
  const auto still = [&](double frames) {
    return renderStill(smallScene(), frames / 24, folder / "still.png");
  };
  for (const auto& [time, frame] :
       {std::pair{0.0, 0}, {5.0, 5}, {5.4, 5}, {5.6, 6}, {11.0, 11}, {12.0, 11}}) {
    EXPECT_EQ(still(time), frame) << time;
    EXPECT_EQ(bytesOf(folder / "still.png"), bytesOf(folder / "small" / frameName(frame))) << time;
  }
}

TEST(Still, MustBeInTheClip) {
  const fs::path path = testing::emptyFolder() / "still.png";
  for (const double time : {-0.1, 0.51, std::nan("")}) {
    EXPECT_THAT(testing::messageOf<InputError>([&] { renderStill(smallScene(), time, path); }),
                HasSubstr("the clip lasts from 0 to 0.5 s"));
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST(Still, MayBeInTheSecondAfterTheMotionDiverges) {
  const fs::path path = testing::emptyFolder() / "still.png";
  const auto still = [&](double time) {
    return renderStill(testing::divergingScene(), time, path);
  };
  EXPECT_EQ(still(28.0 / 24), 28);
  fs::remove(path);
  EXPECT_EQ(testing::messageOf<InputError>([&] { still(1.25); }),
            "there is no picture at 1.25 s: the clip lasts from 0 to 1.2083333333333333 s, a "
            "second after its motion diverges");
  EXPECT_FALSE(fs::exists(path));
}

// Whether any pixel within `margin` of the picture's border differs from `background`.
bool touchesBorder(const image::Image& picture, const image::Image& background, int margin) {
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const int fromSide = std::min(x, picture.width() - 1 - x);
      const int fromTop = std::min(y, picture.height() - 1 - y);
      if (std::min(fromSide, fromTop) >= margin) continue;
      if (!std::equal(picture.row(y) + 4 * x, picture.row(y) + 4 * x + 4,
                      background.row(y) + 4 * x)) {
        return true;
      }
    }
  }
  return false;
}

// Books in attitudes all round, each with a corner turned toward one of many directions.
bool anyAttitudeTouchesBorder(const scene::Scene& scene, int margin) {
  render::Renderer renderer = makeRenderer(scene);
  image::Image background = renderer.makePicture(), picture = renderer.makePicture();
  renderer.draw(scene.body.corners().colwise() + Eigen::Vector3d(0, 1000, 0), background);
  const Eigen::Vector3d corner = scene.body.corners().col(7);
  bool touches = false;
  for (int i = 0; i < 60; ++i) {
    const double height = std::sin(0.9 * i), angle = 2.4 * i;
    const double radius = std::sqrt(1 - height * height);
    const Eigen::Vector3d toward(radius * std::cos(angle), height, radius * std::sin(angle));
    const auto turn = Eigen::Quaterniond::FromTwoVectors(corner, toward);
    renderer.draw(turn.toRotationMatrix() * scene.body.corners(), picture);
    touches = touches || touchesBorder(picture, background, margin);
  }
  return touches;
}

TEST(DefaultCamera, ShowsAllOfTheBookInAnyAttitude) {
  for (const char* size : {"clip.size=[128,72]", "clip.size=[72,128]", "clip.size=[96,96]"}) {
    EXPECT_FALSE(anyAttitudeTouchesBorder(smallScene({size}), 1)) << size;
    EXPECT_TRUE(anyAttitudeTouchesBorder(smallScene({size}), 12)) << size << " shows it small";
  }
}

}  // namespace
}  // namespace rotatebook::pipeline
