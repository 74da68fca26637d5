#include "picture/poster.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "image/png_file.h"
#include "pipeline/small_clip.h"

namespace rotatebook::picture {
namespace {

using pipeline::testing::bytesOf;
using pipeline::testing::smallScene;

TEST(Poster, IsThatFrameOfTheClip) {
  const auto folder = pipeline::testing::emptyFolder();
  pipeline::testing::render(smallScene({"clip.poster=0.125"}),
                            {.folder = folder, .outputs = {pipeline::pngOutput()}});
  const image::Image poster = image::readPng(folder / "small.poster.png");
  EXPECT_EQ(poster, image::readPng(folder / "small" / store::frameName(3)));
  EXPECT_FALSE(poster == image::readPng(folder / "small" / store::frameName(4)));
}

TEST(Poster, IsNotMadeOfAPartOfTheClip) {
  const auto folder = pipeline::testing::emptyFolder();
  pipeline::testing::render(
      smallScene(),
      {.folder = folder, .outputs = {pipeline::pngOutput()}, .frames = store::FrameRange{0, 2}});
  EXPECT_FALSE(std::filesystem::exists(folder / "small.poster.png"));
}

}  // namespace
}  // namespace rotatebook::picture
