// Pictures without a background: what keeps their alpha, and what refuses them.
#include <cstdint>
#include <filesystem>

#include <gtest/gtest.h>

#include "base/error.h"
#include "image/png_file.h"
#include "picture/still.h"
#include "pipeline/small_clip.h"
#include "video/decoded_pictures.h"

namespace rotatebook::pipeline {
namespace {

using testing::smallScene;
using video::VideoFormat;
using video::testing::decodePictures;

scene::Scene transparentScene() {
  return smallScene({"look.background=transparent"});
}

int alphaAt(const image::Image& picture, int x, int y) {
  return picture.row(y)[4 * x + 3];
}

TEST(Transparent, FramesPosterAndStillKeepTheirAlpha) {
  const auto folder = testing::emptyFolder();
  testing::render(transparentScene(), {.folder = folder, .outputs = {pngOutput()}});
  picture::renderStill(transparentScene(), 0, folder / "still.png");
  for (const auto& path : {folder / "small" / store::frameName(0), folder / "small.poster.png",
                           folder / "still.png"}) {
    const image::Image picture = image::readPng(path);
    ASSERT_EQ(picture.format(), image::PixelFormat::Rgba8) << path;
    EXPECT_EQ(alphaAt(picture, 0, 0), 0) << path;
    EXPECT_EQ(alphaAt(picture, 32, 18), 255) << path;
  }
}

TEST(Transparent, PicturesWithABackgroundHaveNoAlpha) {
  const auto folder = testing::emptyFolder();
  testing::render(smallScene(), {.folder = folder, .outputs = {pngOutput()}});
  EXPECT_EQ(image::readPng(folder / "small" / store::frameName(0)).format(),
            image::PixelFormat::Rgb8);
}

TEST(Transparent, WebMAndApngKeepTheirAlpha) {
  constexpr int kBound = 8;  // of 255
  const auto folder = testing::emptyFolder();
  testing::render(
      transparentScene(),
      {.folder = folder, .outputs = outputsOf(true, {VideoFormat::WebM, VideoFormat::Apng})});
  for (const char* name : {"small.webm", "small.apng"}) {
    const auto decoded = decodePictures(folder / name);
    ASSERT_EQ(decoded.pictures.size(), testing::kFrames) << name;
    EXPECT_LT(alphaAt(decoded.pictures[0].picture, 0, 0), kBound) << name;
    EXPECT_GT(alphaAt(decoded.pictures[0].picture, 32, 18), 255 - kBound) << name;
  }
  EXPECT_EQ(decodePictures(folder / "small.apng").pictures[3].picture,
            image::readPng(folder / "small" / store::frameName(3)));
}

TEST(Transparent, Mp4AndGifRefuse) {
  const auto folder = testing::emptyFolder();
  for (const VideoFormat format : {VideoFormat::Mp4, VideoFormat::Gif}) {
    EXPECT_THROW(testing::render(transparentScene(),
                                 {.folder = folder, .outputs = outputsOf(true, {format})}),
                 InputError);
  }
  EXPECT_TRUE(testing::namesIn(folder).empty());
}

}  // namespace
}  // namespace rotatebook::pipeline
