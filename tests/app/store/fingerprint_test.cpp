#include "store/fingerprint.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "image/image.h"
#include "image/png_file.h"
#include "picture/frame_drawer.h"
#include "pipeline/small_clip.h"
#include "store/clip_files.h"
#include "store/clip_record.h"
#include "system/atomic_file.h"
#include "system/file_checksum.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::store {
namespace {

namespace fs = std::filesystem;
using pipeline::testing::emptyFolder;
using pipeline::testing::smallScene;
using ::testing::HasSubstr;

Manifest::Entries madeOf(const scene::Scene& scene, const Drawing& drawing = {"r", "t"}) {
  return fingerprint(scene, picture::loadLooks(scene).checksums, drawing);
}

TEST(Fingerprint, ChangesWithAllThatFramesDependOn) {
  const auto made = madeOf(smallScene());
  EXPECT_EQ(made, madeOf(smallScene()));
  EXPECT_NE(made, madeOf(smallScene({"body.mass=2"})));
  EXPECT_NE(made, madeOf(smallScene(), {"another", "t"}));
  EXPECT_NE(made, madeOf(smallScene(), {"r", "another"}));
  for (const char* key : {"program", "build", "renderer", "test frame", "scene", "book.front"}) {
    EXPECT_THAT(made.at(key), Not(::testing::IsEmpty())) << key;
  }
  EXPECT_EQ(made.count("ffmpeg"), 0U);
}

/// Returns the words of docs/tables/reliability.md for what frames.manifest holds about the frames.
std::set<std::string> documentedEntries() {
  std::ifstream file(fs::path(ROTATEBOOK_SOURCE) / "docs/tables/reliability.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  const std::string beginning = "`frames.manifest`, what the frames were made with: ";
  const std::size_t begin = page.find(beginning) + beginning.size();
  std::istringstream list(page.substr(begin, page.find(';', begin) - begin));
  std::set<std::string> words;
  for (std::string word; std::getline(list >> std::ws, word, ',');) words.insert(word);
  return words;
}

TEST(Fingerprint, HoldsWhatTheDocumentationSays) {
  std::set<std::string> entries;
  for (const auto& [key, value] : madeOf(smallScene())) {
    const bool isTexture = key.starts_with("book.");
    entries.insert(isTexture ? "textures" : key);
  }
  EXPECT_EQ(documentedEntries(), entries);
}

TEST(Fingerprint, ChangesWithATexturesBytes) {
  const fs::path folder = emptyFolder();
  scene::Scene scene = smallScene();
  scene.folder = folder;
  scene.book.front = "cover.png";
  image::Image picture(4, 4, image::PixelFormat::Rgb8);
  image::writePng(folder / "cover.png", picture.view());
  const auto made = madeOf(scene);
  picture.row(0)[0] ^= 1;
  image::writePng(folder / "cover.png", picture.view());
  EXPECT_NE(madeOf(scene).at("book.front"), made.at("book.front"));
}

TEST(Fingerprint, IsOfTheTexturesThatWereDrawn) {
  const fs::path folder = emptyFolder(), cover = folder / "cover.png";
  scene::Scene scene = smallScene();
  scene.folder = folder;
  scene.book.front = "cover.png";
  image::Image picture(4, 4, image::PixelFormat::Rgb8);
  image::writePng(cover, picture.view());
  const std::string drawn = system::checksumOfFile(cover);
  const timeline::ClipMotion motion = timeline::simulateScene(scene);
  const picture::FrameDrawer drawer(scene, motion);
  picture.row(0)[0] ^= 1;
  image::writePng(cover, picture.view());
  EXPECT_NE(system::checksumOfFile(cover), drawn);
  const auto made = fingerprint(scene, drawer.textureChecksums(), {drawer.description(), "t"});
  EXPECT_EQ(made.at("book.front"), drawn);
  EXPECT_EQ(provenanceOf(scene, "", drawer.textureChecksums(), "r", "").textures,
            "book.front " + drawn);
}

TEST(Differences, NameTheKeysAndBothValues) {
  const fs::path folder = emptyFolder();
  const scene::Scene there = smallScene();
  system::writeFileAtomically(folder / kSceneCopyName,
                              sceneRecord(there, {.scene = "small", .renderer = "r"}));
  const scene::Scene here = smallScene({"body.mass=2", "camera.position=[0, 0, 2]"});
  EXPECT_THAT(differences(folder, madeOf(there), madeOf(here, {"s", "t"}), here),
              AllOf(HasSubstr("body.mass is 1.0 there, 2.0 here; "),
                    HasSubstr("camera.position[0] is "), HasSubstr("; and ")));
  EXPECT_EQ(differences(folder, madeOf(there), madeOf(there, {"s", "t"}), there),
            "renderer is r there, s here");
  EXPECT_EQ(differences(folder, {{"renderer", "r"}}, {{"renderer", "r"}, {"x", "1"}}, there),
            "x is missing there, 1 here");
}

}  // namespace
}  // namespace rotatebook::store
