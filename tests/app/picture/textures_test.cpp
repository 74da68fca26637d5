#include "picture/textures.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "image/png_file.h"
#include "picture/frame_drawer.h"
#include "picture/preflight.h"
#include "pipeline/small_clip.h"

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

TEST(Textures, AreThoseThatWereReadEvenIfTheFileChanges) {
  const fs::path folder = emptyFolder();
  const scene::Scene scene = coveredScene(folder);
  writeCover(folder, 8);
  const TextureFiles files = preflight(scene);
  const TextureChecksums checksums = loadTextures(scene).checksums;
  writeCover(folder, 9);
  const LoadedTextures loaded = loadTextures(scene, files);
  EXPECT_EQ(loaded.pictures.front.width(), 8);
  EXPECT_EQ(loaded.checksums, checksums);
  EXPECT_NE(loadTextures(scene).checksums, checksums);
  const timeline::ClipMotion motion = timeline::simulateScene(scene);
  EXPECT_EQ(FrameDrawer(scene, motion, {}, files).textureChecksums(), checksums);
}

TEST(Textures, AreReadUnlessBuiltIn) {
  EXPECT_TRUE(readTextures(smallScene()).empty());
  const fs::path folder = emptyFolder();
  writeCover(folder, 8);
  EXPECT_EQ(readTextures(coveredScene(folder)).count("book.front"), 1U);
}

}  // namespace
}  // namespace rotatebook::picture
