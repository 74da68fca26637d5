// The file is read back by the reader of meshes.
#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "image/picture_file.h"
#include "meshes/mesh_readers.h"
#include "messages.h"
#include "physics/simulate.h"
#include "picture/interchange/motion_file.h"
#include "picture/interchange/played.h"
#include "scene/scene_text.h"
#include "timeline/motion_checksum.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::interchange {
namespace {

using Eigen::Quaterniond;
using testing::documentOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::Played;
using testing::sceneOf;

/// Returns the most that the animation is off the motion at 1,000 times of the video. [degrees]
double errorOf(const scene::Scene& scene, const Played& played) {
  constexpr int kTimes = 1000;
  std::vector<double> shown, times;
  for (int i = 0; i < kTimes; ++i) {
    shown.push_back(played.times().back() * i / (kTimes - 1));
    times.push_back(timeAt(scene, shown.back() / scene.clip.frameRate.period()));
  }
  const auto motion = physics::simulate(scene.motions.front().motion(), times);
  double largest = 0;
  for (std::size_t i = 0; i < shown.size(); ++i)
    largest =
        std::max(largest, played.attitudeAt(shown[i]).angularDistance(motion.samples[i].attitude));
  return largest * 180 / std::numbers::pi;
}

double errorOf(const scene::Scene& scene, const KeyOptions& options) {
  const MotionFile glb = motionGlb(scene, 0, options);
  const double error = errorOf(scene, Played(glb.bytes, 0));
  // Times are rounded to 32 bits: measured 1.4e-4
  EXPECT_NEAR(error, glb.errorDeg, 0.05 * error + 2e-4);
  return error;
}

TEST(MotionGlb, TurnsTheBodyAsTheMotionDoes) {
  const scene::Scene scene = sceneOf();
  EXPECT_LT(errorOf(scene, {}), 0.04);                                        // measured 0.030
  EXPECT_LT(errorOf(scene, {.keysPerSecond = 15, .tangents = true}), 0.002);  // measured 0.0015
  EXPECT_LT(errorOf(scene, {.tangents = true}), 2e-4);                        // measured 1.5e-4
  EXPECT_GT(errorOf(scene, {.keysPerSecond = 30}), 0.1);                      // measured 0.118
}

TEST(MotionGlb, TakesMoreKeysForAFastSpin) {
  const scene::Scene scene = sceneOf("clip.duration = 4\n", "20.0");
  EXPECT_GT(errorOf(scene, {.keysPerSecond = 60}), 0.4);  // measured 0.473
  EXPECT_LT(errorOf(scene, {}), 0.05);                    // measured 0.030
  EXPECT_EQ(motionGlb(scene, 0, {}).keys, 957U);
}

// Whatever the keys are simulated with.
TEST(MotionGlb, HasTheSameAttitudesAtTheSameTimes) {
  const scene::Scene scene = sceneOf("clip.duration = 4\n", "20.0");
  const Played few(motionGlb(scene, 0, {.keysPerSecond = 60}).bytes, 0);
  const Played many(motionGlb(scene, 0, {}).bytes, 0);
  ASSERT_EQ(many.times().size(), 957U);
  for (std::size_t i = 0; i < few.times().size(); ++i) {
    ASSERT_EQ(many.times()[4 * i], few.times()[i]);
    ASSERT_EQ(many.key(4 * i), few.key(i)) << i;
  }
}

// It holds, and passes from speed to speed.
TEST(MotionGlb, GoesByTheClockOfTheVideo) {
  const scene::Scene scene = sceneOf(R"(clip.fps = 25
clip.speed = [{ from = 2, to = 4, value = 0.25 }, { from = 5, to = 6, value = 0 }]
)");
  EXPECT_LT(errorOf(scene, {}), 0.04);                  // measured 0.030
  EXPECT_LT(errorOf(scene, {.tangents = true}), 2e-4);  // measured 1.4e-4
  const MotionFile glb = motionGlb(scene, 0, {});
  EXPECT_EQ(glb.keys, 718U);  // Up to the last of 300 frames, at 11.96 s
  EXPECT_NEAR(glb.seconds, 11.95, 1e-9);
}

TEST(MotionGlb, KeepsTheSignOfItsAttitudesAndItsTimesRise) {
  for (const bool tangents : {false, true}) {
    const std::string bytes = motionGlb(sceneOf(), 0, {.tangents = tangents}).bytes;
    const Played played(bytes, 0);
    ASSERT_EQ(played.times().size(), 720U);
    EXPECT_EQ(played.times().front(), 0);
    for (std::size_t i = 1; i < 720; ++i) {
      ASSERT_GT(played.times()[i], played.times()[i - 1]);
      ASSERT_GT(played.key(i).dot(played.key(i - 1)), 0.99) << i;
    }
    const nlohmann::json json = documentOf(bytes);
    const auto& input =
        json["accessors"][json["animations"][0]["samplers"][0]["input"].get<std::size_t>()];
    EXPECT_THAT(input["min"], ElementsAre(0));
    EXPECT_THAT(input["max"], ElementsAre(played.times().back()));
  }
}

TEST(MotionGlb, HoldsTheBookAsItLiesAtTheStart) {
  const scene::Scene scene = sceneOf();
  const body::Surface surface = meshes::readGlb(motionGlb(scene, 0, {}).bytes).surface;
  const auto start = physics::simulate(scene.motions.front().motion(), 1).samples.front();
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3d& point : surface.mesh.points)
    points.push_back(start.attitude.conjugate() * point);
  const body::Box box = body::boxAround(points);
  EXPECT_TRUE((box.high - box.low).isApprox(scene.motions.front().body.size, 1e-4));
  EXPECT_GT(surface.mesh.triangles.size(), 1000U);
  // Those of the sides and the leaves, and the reader's own
  EXPECT_EQ(surface.materials.size(), 5U);
  EXPECT_EQ(surface.images.size(), 4U);
}

TEST(MotionGlb, HasGoldWhereTheCoverHas) {
  scene::Scene scene = sceneOf();
  scene.book.colour.reset();
  const body::Surface surface = meshes::readGlb(motionGlb(scene, 0, {}).bytes).surface;
  EXPECT_EQ(surface.images.size(), 7U) << "one more of each cover";
  EXPECT_EQ(std::ranges::count(surface.materials, 1.0F, &body::Material::metalness), 3);
  const auto gold = std::ranges::find(surface.materials, 1.0F, &body::Material::metalness);
  ASSERT_NE(gold->metalRoughnessImage, body::kNoImage);
  const std::string& file = surface.images[static_cast<std::size_t>(gold->metalRoughnessImage)];
  const image::Image picture = image::decodePicture(
      {reinterpret_cast<const std::uint8_t*>(file.data()), file.size()}, "gold");
  int metal = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) metal += picture.row(y)[3 * x + 2];
  }
  EXPECT_NEAR(metal / 255.0 / (picture.width() * picture.height()), 0.08, 0.02);  // measured 0.094
}

TEST(MotionGlb, IsSmallWithTheCover) {
  scene::Scene scene = sceneOf("clip.duration = 24\n");
  scene.book.colour.reset();
  EXPECT_LT(motionGlb(scene, 0, {}).bytes.size(), 400'000U);  // measured 342,712
}

TEST(MotionGlb, SaysWhatItIsOf) {
  const scene::Scene scene = sceneOf();
  const std::string bytes = motionGlb(scene, 0, {}).bytes;
  EXPECT_TRUE(isMotionFile(bytes));
  const nlohmann::json extras = documentOf(bytes)["asset"]["extras"];
  EXPECT_EQ(scene::parseScene(extras["scene"].get<std::string>(), "throw.toml").motions,
            scene.motions);
  EXPECT_EQ(extras["motion_xxh128"], timeline::motionChecksum(timeline::simulateScene(scene)));
  EXPECT_TRUE(bytes == motionGlb(scene, 0, {}).bytes);
}

TEST(MotionGlb, TurnsTheCameraWithItsFrame) {
  const scene::Scene scene = sceneOf("camera.frame = \"body\"\n");
  const std::string bytes = motionGlb(scene, 0, {}).bytes;
  const Played body(bytes, 0), place(bytes, 1), camera(bytes, 2);
  EXPECT_EQ(place.path(), "translation");
  // The camera sees the book at rest
  const auto seen = [&](std::size_t i) {
    return Quaterniond(camera.key(i)).conjugate() * Quaterniond(body.key(i));
  };
  double largest = 0;
  for (std::size_t i = 0; i < 720; ++i)
    largest = std::max(largest, seen(i).angularDistance(seen(0)));
  EXPECT_LT(largest, 1e-6);  // measured 1.2e-7
  EXPECT_GT((place.key(300) - place.key(0)).norm(), 0.1);
  EXPECT_EQ(documentOf(motionGlb(sceneOf(), 0, {}).bytes)["animations"][0]["channels"].size(), 1U);
}

TEST(MotionGlb, HasOtherBodiesAndPanels) {
  const scene::Scene scene = scene::parseScene(R"([initial]
angular_velocity = [5.0, 0.0, 0.0]
[clip]
duration = 0.2
[[panel]]
label = "one"
[[panel]]
label = "disc"
body = { shape = "disc" }
)",
                                               "two.toml");
  const std::string bytes = motionGlb(scene, 1, {}).bytes;
  const nlohmann::json document = documentOf(bytes);
  EXPECT_EQ(document["asset"]["extras"]["panel"], "disc");
  EXPECT_EQ(document["materials"].size(), 1U);
  EXPECT_THAT(meshes::readGlb(bytes).surface.images, IsEmpty());
}

TEST(MotionGlb, HasTheGrainOfItsMaterials) {
  const scene::Scene wooden = scene::parseScene(R"([initial]
angular_velocity = [5.0, 0.0, 0.0]
[clip]
duration = 0.2
[body]
shape = "racket"
)",
                                                "wooden.toml");
  const body::Surface surface = meshes::readGlb(motionGlb(wooden, 0, {}).bytes).surface;
  int grains = 0;
  for (const body::Material& material : surface.materials) {
    if (material.baseColourImage == body::kNoImage) continue;
    ++grains;
    const std::string& file = surface.images[static_cast<std::size_t>(material.baseColourImage)];
    const image::Image tile = image::decodePicture(
        {reinterpret_cast<const std::uint8_t*>(file.data()), file.size()}, "grain");
    EXPECT_EQ(tile.width(), tile.height());
    // It goes on beyond its edges: columns there are as near as neighbours within
    int atEdge = 0, within = 0;
    for (int y = 0; y < tile.height(); ++y) {
      const std::uint8_t* row = tile.row(y);
      atEdge += std::abs(row[0] - row[3 * (tile.width() - 1)]);
      within += std::abs(row[3 * 64] - row[3 * 63]);
    }
    EXPECT_LT(atEdge, 1.5 * within);  // measured 0.83 to 0.94 times
  }
  EXPECT_EQ(grains, 3);
}

std::string refusalOf(const scene::Scene& scene) {
  try {
    motionGlb(scene, 0, {});
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(MotionGlb, IsRefusedWhereThereAreManyMotions) {
  EXPECT_EQ(refusalOf(sceneOf()), "accepted");
  EXPECT_MESSAGE(refusalOf(sceneOf("grid.columns = { key = \"body.mass\", values = [1, 2] }\n")));
}

TEST(MotionGlb, SaysThatItsKeysAreTooFew) {
  EXPECT_THAT(motionGlb(sceneOf(), 0, {}).notes, IsEmpty());
  EXPECT_THAT(motionGlb(sceneOf(), 0, {.keysPerSecond = 3}).notes,
              ElementsAre(HasSubstr("take more keys")));
  EXPECT_THAT(motionGlb(sceneOf("clip.duration = 1\n", "4e4"), 0, {}).notes,
              ElementsAre(HasSubstr("it turns too fast for keys")));
}

}  // namespace
}  // namespace rotatebook::interchange
