// The archive is read byte by byte: libzip would forgive more than programs for USDZ do.
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "physics/simulate.h"
#include "picture/interchange/motion_file.h"
#include "picture/interchange/played.h"
#include "timeline/motion_checksum.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::interchange {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Key;
using ::testing::Not;
using testing::sceneOf;
using ::testing::StartsWith;

/// Returns the number of so many bytes at a place.
std::size_t numberAt(const std::string& bytes, std::size_t at, std::size_t size) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + at, size);
  return number;
}

/// Returns the files of an archive, each of which must be stored at a multiple of 64.
std::map<std::string, std::string> filesOf(const std::string& zip) {
  std::map<std::string, std::string> files;
  std::size_t at = 0;
  while (zip.compare(at, 4, "PK\3\4") == 0) {
    EXPECT_EQ(numberAt(zip, at + 6, 2) & 9U, 0U) << "encrypted, or its size comes later";
    EXPECT_EQ(numberAt(zip, at + 8, 2), 0U) << "compressed";
    const std::size_t size = numberAt(zip, at + 18, 4), name = numberAt(zip, at + 26, 2),
                      extra = numberAt(zip, at + 28, 2), begin = at + 30 + name + extra;
    EXPECT_EQ(begin % 64, 0U);
    files[zip.substr(at + 30, name)] = zip.substr(begin, size);
    at = begin + size;
  }
  EXPECT_EQ(zip.substr(at, 4), "PK\1\2");
  return files;
}

std::string layerOf(const scene::Scene& scene, const KeyOptions& options = {}) {
  return filesOf(motionUsdz(scene, 0, options).bytes).at("motion.usda");
}

std::size_t countOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

TEST(MotionUsdz, IsAnArchiveThatCanBeReadInPlace) {
  scene::Scene scene = sceneOf();
  scene.book.colour.reset();
  const std::string bytes = motionUsdz(scene, 0, {}).bytes;
  const auto files = filesOf(bytes);
  EXPECT_THAT(files,
              ElementsAre(Key("motion.usda"), Key("pictures/1.jpg"), Key("pictures/2.jpg"),
                          Key("pictures/3.jpg"), Key("pictures/4.jpg"), Key("pictures/5.jpg"),
                          Key("pictures/6.jpg"), Key("pictures/7.jpg")));
  for (const auto& [name, file] : files) {
    if (name == "motion.usda") continue;
    EXPECT_THAT(file, StartsWith("\xFF\xD8"));
    EXPECT_THAT(files.at("motion.usda"), HasSubstr("@" + name + "@"));
  }
  EXPECT_TRUE(isMotionFile(bytes));
  EXPECT_FALSE(isMotionFile(bytes.substr(1)));
  EXPECT_TRUE(bytes == motionUsdz(scene, 0, {}).bytes);
}

TEST(MotionUsdz, TurnsTheBodyAsTheMotionDoes) {
  const scene::Scene scene = sceneOf();
  const MotionFile file = motionUsdz(scene, 0, {});
  const std::string layer = layerOf(scene);
  EXPECT_THAT(layer, StartsWith("#usda 1.0\n"));
  EXPECT_THAT(layer, HasSubstr("    timeCodesPerSecond = 60\n"));
  EXPECT_THAT(layer, HasSubstr("    endTimeCode = 719\n"));
  EXPECT_EQ(file.keys, 720U);
  EXPECT_LT(file.errorDeg, 0.04);  // measured 0.030
  const auto motion = physics::simulate(scene.motions.front().motion(), std::vector{0.0, 7.5});
  const Eigen::Quaternionf q = motion.samples[1].attitude.cast<float>();
  EXPECT_THAT(layer, HasSubstr(fmt::format("\n            450: ({}, {}, {}, {}),\n", q.w(), q.x(),
                                           q.y(), q.z())));
}

TEST(MotionUsdz, SaysWhatItIsOf) {
  const scene::Scene scene = sceneOf();
  const std::string layer = layerOf(scene);
  EXPECT_THAT(layer, HasSubstr("string motion_xxh128 = \"" +
                               timeline::motionChecksum(timeline::simulateScene(scene)) + "\""));
  EXPECT_THAT(layer, HasSubstr(R"(string scene = "title = \"Throw\"\n)"));
  EXPECT_EQ(countOf(layer, "{"), countOf(layer, "}"));
}

TEST(MotionUsdz, BindsEachTriangleToAMaterial) {
  const std::string layer = layerOf(sceneOf());
  for (const std::string name : {"front", "spine", "back", "pages"}) {
    EXPECT_THAT(layer, HasSubstr("def GeomSubset \"" + name + "\""));
    EXPECT_THAT(layer,
                HasSubstr("rel material:binding = </motion/turning/materials/" + name + ">"));
    EXPECT_THAT(layer, HasSubstr("def Material \"" + name + "\""));
  }
  EXPECT_EQ(countOf(layer, "UsdTransform2d"), 0U);  // which phones don't know
}

TEST(MotionUsdz, HasOtherBodies) {
  const scene::Scene scene = scene::parseScene(R"([initial]
angular_velocity = [5.0, 0.0, 0.0]
[clip]
duration = 0.2
[body]
shape = "disc"
)",
                                               "disc.toml");
  const auto files = filesOf(motionUsdz(scene, 0, {}).bytes);
  EXPECT_THAT(files, ElementsAre(Key("motion.usda")));
  EXPECT_THAT(files.at("motion.usda"), HasSubstr("color3f inputs:diffuseColor = ("));
  EXPECT_THAT(files.at("motion.usda"), Not(HasSubstr("UsdUVTexture")));
}

TEST(MotionUsdz, TurnsTheCameraWithItsFrame) {
  EXPECT_EQ(countOf(layerOf(sceneOf()), "timeSamples"), 1U);
  const std::string layer = layerOf(sceneOf("clip.fps = 30\ncamera.frame = \"body\"\n"));
  EXPECT_EQ(countOf(layer, "timeSamples"), 3U);
  EXPECT_THAT(layer, HasSubstr("\n            718: ("));
}

TEST(MotionUsdz, IsRefusedWithTangents) {
  EXPECT_THROW(motionUsdz(sceneOf(), 0, {.tangents = true}), InputError);
}

}  // namespace
}  // namespace rotatebook::interchange
