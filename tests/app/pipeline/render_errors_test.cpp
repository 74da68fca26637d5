// Renders that can't be done: their messages, and the files that they leave.
#include <filesystem>
#include <fstream>
#include <string>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "image/png_file.h"
#include "messages.h"
#include "pipeline/small_clip.h"

namespace rotatebook::pipeline {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using testing::emptyFolder;
using testing::namesIn;
using testing::pngAndMp4;
using testing::smallScene;

template <typename Expected>
std::string errorOf(const scene::Scene& scene, const RenderOptions& options) {
  return testing::messageOf<Expected>([&] { testing::render(scene, options); });
}

TEST(RenderErrors, NameAFileInPlaceOfTheOutputFolder) {
  const fs::path folder = emptyFolder();
  std::ofstream(folder / "out") << "a file";
  EXPECT_MESSAGE(errorOf<MachineError>(smallScene(), pngAndMp4(folder / "out")));
  EXPECT_THAT(namesIn(folder), ElementsAre("out"));
}

TEST(RenderErrors, NameAFileInPlaceOfTheFrameFolder) {
  const fs::path folder = emptyFolder();
  std::ofstream(folder / "small") << "a file";
  EXPECT_MESSAGE(errorOf<MachineError>(smallScene(), pngAndMp4(folder)));
  EXPECT_THAT(namesIn(folder), ElementsAre("small"));
}

TEST(RenderErrors, NameAFolderInPlaceOfTheVideo) {
  const fs::path folder = emptyFolder();
  fs::create_directories(folder / "small.mp4");
  EXPECT_MESSAGE(errorOf<MachineError>(
      smallScene(), {.folder = folder, .outputs = outputsOf(false, {video::VideoFormat::Mp4})}));
  EXPECT_THAT(namesIn(folder), ElementsAre("small.mp4"));
}

TEST(RenderErrors, NameAFrameThatCannotBeWritten) {
  const fs::path folder = emptyFolder();
  const RenderListener listener{
      [&](const RenderStart&) {
        fs::create_directories(folder / "small.partial" / store::frameName(4) / "in the way");
      },
      {}};
  const auto render = [&] {
    renderClip(smallScene(), timeline::simulateScene(smallScene()), pngAndMp4(folder), listener);
  };
  EXPECT_MESSAGE(testing::messageOf<MachineError>(render));
  EXPECT_FALSE(fs::exists(folder / "small.mp4"));
  EXPECT_THAT(namesIn(folder), ElementsAre("small.partial")) << "something unfinished is left";
}

TEST(RenderErrors, NameAFolderInPlaceOfAnOlderFrame) {
  const fs::path folder = emptyFolder();
  fs::create_directories(folder / "small" / store::frameName(4) / "in the way");
  EXPECT_MESSAGE(errorOf<MachineError>(smallScene(), pngAndMp4(folder, {.overwrite = true})));
}

TEST(RenderErrors, NameATextureThatIsMissing) {
  const fs::path folder = emptyFolder();
  const scene::Scene scene = smallScene({"book.spine=nowhere.png"});
  EXPECT_MESSAGE(errorOf<InputError>(scene, pngAndMp4(folder)));
  EXPECT_TRUE(namesIn(folder).empty());
}

TEST(RenderErrors, NameATextureThatIsBroken) {
  const fs::path folder = emptyFolder();
  std::ofstream(folder / "broken.png") << "\x89PNG no more";
  scene::Scene scene = smallScene({"book.back=broken.png"});
  scene.folder = folder;
  EXPECT_MESSAGE(errorOf<InputError>(scene, pngAndMp4(folder / "out")));
  EXPECT_FALSE(fs::exists(folder / "out"));
}

// A picture of one colour whose channels say which it is.
void writeColour(const fs::path& path, int red, int green, int blue) {
  image::Image picture(8, 8, image::PixelFormat::Rgb8);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      picture.row(y)[3 * x] = static_cast<std::uint8_t>(red);
      picture.row(y)[3 * x + 1] = static_cast<std::uint8_t>(green);
      picture.row(y)[3 * x + 2] = static_cast<std::uint8_t>(blue);
    }
  }
  image::writePng(path, picture.view());
}

TEST(Textures, AreThoseOfTheSceneEachOnItsSide) {
  const fs::path folder = emptyFolder();
  writeColour(folder / "f.png", 255, 0, 0);
  writeColour(folder / "s.png", 0, 255, 0);
  writeColour(folder / "b.png", 0, 0, 255);
  scene::Scene scene = smallScene({"book.front=f.png", "book.spine=s.png", "book.back=b.png"});
  scene.folder = folder;
  const render::BookTextures textures =
      std::get<render::BookTextures>(picture::loadLooks(scene).looks.at(0));
  EXPECT_THAT(std::vector(textures.front.row(0), textures.front.row(0) + 3),
              ElementsAre(255, 0, 0));
  EXPECT_THAT(std::vector(textures.spine.row(0), textures.spine.row(0) + 3),
              ElementsAre(0, 255, 0));
  EXPECT_THAT(std::vector(textures.back.row(0), textures.back.row(0) + 3), ElementsAre(0, 0, 255));
}

TEST(Textures, AreTheBuiltInOnesByDefault) {
  const render::BookTextures textures =
      std::get<render::BookTextures>(picture::loadLooks(scene::testing::smallScene()).looks.at(0));
  EXPECT_EQ(textures.front, render::builtinFront());
  EXPECT_EQ(textures.spine, render::builtinSpine());
  EXPECT_EQ(textures.back, render::builtinBack());
}

}  // namespace
}  // namespace rotatebook::pipeline
