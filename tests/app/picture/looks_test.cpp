#include "picture/looks.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "base/checksum.h"
#include "base/error.h"
#include "image/png_file.h"
#include "messages.h"
#include "picture/frame_drawer.h"
#include "picture/preflight.h"
#include "picture/still.h"
#include "pipeline/small_clip.h"
#include "scene/scene_text.h"
#include "system/read_file.h"

namespace rotatebook::picture {
namespace {

namespace fs = std::filesystem;
using pipeline::testing::emptyFolder;
using pipeline::testing::smallScene;

void writeCover(const fs::path& folder, int width) {
  image::writePng(folder / "cover.png", image::Image(width, 12, image::PixelFormat::Rgb8).view());
}

scene::Scene coveredScene(const fs::path& folder) {
  scene::Scene scene = smallScene({"book.front=cover.png"});
  scene.folder = folder;
  return scene;
}

render::BookTextures bookOf(const LoadedLooks& loaded) {
  return std::get<render::BookTextures>(loaded.looks.at(0));
}

render::BookTextures bookOf(const scene::Scene& scene) {
  return bookOf(loadLooks(scene));
}

TEST(Textures, AreThoseThatWereReadEvenIfTheFileChanges) {
  const fs::path folder = emptyFolder();
  const scene::Scene scene = coveredScene(folder);
  writeCover(folder, 8);
  const TextureFiles files = preflight(scene).textures;
  const TextureChecksums checksums = loadLooks(scene).checksums;
  writeCover(folder, 9);
  const LoadedLooks loaded = loadLooks(scene, files);
  EXPECT_EQ(bookOf(loaded).front.width(), 8);
  EXPECT_EQ(loaded.checksums, checksums);
  EXPECT_NE(loadLooks(scene).checksums, checksums);
  const timeline::ClipMotion motion = timeline::simulateScene(scene);
  EXPECT_EQ(FrameDrawer(scene, motion, {}, files).textureChecksums(), checksums);
}

TEST(Textures, AreReadUnlessBuiltIn) {
  EXPECT_TRUE(readTextures(smallScene()).empty());
  const fs::path folder = emptyFolder();
  writeCover(folder, 8);
  EXPECT_EQ(readTextures(coveredScene(folder)).count("book.front"), 1U);
}

TEST(Textures, MayBeJpegsAndWebps) {
  const fs::path folder = emptyFolder();
  const std::string pictures = ROTATEBOOK_SOURCE "/tests/platform/image/pictures/";
  fs::copy_file(pictures + "jpeg/sky.jpg", folder / "cover.png");  // Its name says nothing.
  fs::copy_file(pictures + "webp/alpha.webp", folder / "back");
  scene::Scene scene = smallScene({"book.front=cover.png", "book.back=back"});
  scene.folder = folder;
  const LoadedLooks loaded = loadLooks(scene, preflight(scene).textures);
  EXPECT_EQ(bookOf(loaded).front.width(), 40);
  EXPECT_EQ(bookOf(loaded).back.width(), 24);
  const std::string bytes = system::readFile(folder / "cover.png", 10'000);
  EXPECT_EQ(loaded.checksums.at("book.front"), checksumOf(bytes));
}

TEST(Textures, OfAnotherFormatAreRefusedWithTheSceneLine) {
  const fs::path folder = emptyFolder();
  std::ofstream(folder / "cover.png") << "GIF89a";
  const scene::Scene scene = coveredScene(folder);
  EXPECT_MESSAGE(pipeline::testing::messageOf<InputError>([&] { readTextures(scene); }));
}

TEST(Textures, AreClothOfTheBooksColourWhereThereIsNoPicture) {
  const fs::path folder = emptyFolder();
  writeCover(folder, 8);
  scene::Scene scene = smallScene({"book.front=cover.png", "book.color=#2b5d8a"});
  scene.folder = folder;
  const render::BookTextures textures = bookOf(scene);
  EXPECT_EQ(textures.front.width(), 8);
  EXPECT_EQ(textures.spine, render::plainCloth({0x2b, 0x5d, 0x8a}));
  EXPECT_EQ(textures.back, textures.spine);
  EXPECT_EQ(bookOf(scene::testing::smallScene()).back, render::builtinBack());
}

// Between panels and below a caption, too.
TEST(Still, HasABackgroundOfExactlyTheColour) {
  const fs::path path = emptyFolder() / "still.png";
  const std::string look = "look.background = '#fe80c1'\nclip.size = [128, 96]\n";
  const std::string spin = "[initial]\nangular_velocity = [5, 3, 1]\n";
  const std::string text = "[overlay]\nshow = ['caption', 'clock']\n";
  for (const std::string& more :
       {std::string(), text, text + "[[panel]]\nlabel = 'a'\n[[panel]]\nlabel = 'b'\n"}) {
    renderStill(scene::parseScene(look + spin + more, "small.toml"), 0, path);
    const image::Image picture = image::readPng(path);
    for (const int x : {0, 127}) {
      for (const int y : {0, 95}) {
        const std::uint8_t* pixel = picture.row(y) + 3 * x;
        EXPECT_EQ((std::vector<int>{pixel[0], pixel[1], pixel[2]}),
                  (std::vector<int>{0xfe, 0x80, 0xc1}))
            << more << x << ' ' << y;
      }
    }
  }
}

}  // namespace
}  // namespace rotatebook::picture
