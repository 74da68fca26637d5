#include "timeline/camera_distances.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "scene/scene_text.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::timeline {
namespace {

constexpr std::int64_t kFrames = 180;  // 3 s at 60 frames a second

scene::Scene spinning(const std::vector<std::string>& overrides) {
  return scene::parseScene("[initial]\nangular_velocity = [5, 3, 1]\n[clip]\nduration = 3\n",
                           "a.toml", overrides);
}

/// Returns a motion in which the body's size in frame n is `sizeAt(n)` of its true one.
ClipMotion growing(const scene::Scene& scene, const std::function<double(double)>& sizeAt,
                   bool diverges = false) {
  physics::Trajectory trajectory;
  trajectory.interval = scene.clip.frameRate.period();
  for (std::int64_t n = 0; n < kFrames; ++n) {
    trajectory.samples.emplace_back().cage =
        sizeAt(static_cast<double>(n)) * scene.motions[0].body.corners();
  }
  if (diverges) trajectory.divergedAt = 3;
  return {{trajectory}, scene.clip.frameRate};
}

std::vector<double> distancesOf(const scene::Scene& scene, const ClipMotion& motion) {
  const CameraDistances distances(scene, motion);
  std::vector<double> all;
  for (std::int64_t n = 0; n < motion.frameCount(); ++n) all.push_back(distances.at(0, n));
  return all;
}

double exploding(double frame) {
  return frame < 90 ? 1 : std::exp((frame - 90) / 30);
}

const scene::Scene kFollowing = spinning({"camera.follow='size'"});

TEST(CameraDistances, AreExactlyOneForABodyThatKeepsItsSize) {
  for (const char* model : {"exact", "quaternion", "matrix", "particles"}) {
    const scene::Scene scene =
        spinning({"camera.follow='size'", std::string("simulation.model=") + model,
                  "camera.target=[0.1, 0.2, 0]"});
    for (const double distance : distancesOf(scene, simulateScene(scene))) ASSERT_EQ(distance, 1);
  }
}

TEST(CameraDistances, AreOneUnlessAsked) {
  const scene::Scene scene = spinning({});
  for (const double distance : distancesOf(scene, growing(scene, exploding))) {
    ASSERT_EQ(distance, 1);
  }
}

TEST(CameraDistances, KeepABodyThatGrowsInView) {
  const std::vector<double> distances = distancesOf(kFollowing, growing(kFollowing, exploding));
  for (std::size_t n = 90; n < kFrames - 30; ++n) {
    const double seen = exploding(static_cast<double>(n)) / distances[n] / scene::kRoomAround;
    ASSERT_LE(seen, 1.001) << n;  // measured 1.0000
  }
}

TEST(CameraDistances, ChangeSmoothly) {
  const auto jumping = [](double frame) { return frame < 90 ? 1.0 : 20.0; };
  const std::vector<double> distances = distancesOf(kFollowing, growing(kFollowing, jumping));
  double fastest = 1, before = 1;
  for (const double distance : distances) {
    ASSERT_GE(distance, before);
    fastest = std::max(fastest, distance / before);
    before = distance;
  }
  EXPECT_LT(fastest, 1.15);  // measured 1.13, at a body that grows 20 times between two frames
  EXPECT_NEAR(distances.back(), 20 / scene::kRoomAround, 1e-12);
}

TEST(CameraDistances, ComeBackSlowly) {
  const auto once = [](double frame) { return frame < 30 ? 8.0 : 1.0; };
  const std::vector<double> distances = distancesOf(kFollowing, growing(kFollowing, once));
  EXPECT_LT(distances[140], distances[80]);
  EXPECT_NEAR(distances[140] / distances[80], std::exp2(-1.0 / 3), 1e-9);
}

TEST(CameraDistances, UseTheRoomOfAFartherCamera) {
  const scene::Scene near = kFollowing;
  const std::string position =
      "camera.position=[0, 0, " + std::to_string(2 * near.cameraPosition.norm()) + "]";
  const scene::Scene far = spinning({"camera.follow='size'", position});
  const auto doubling = [](double frame) { return frame < 90 ? 1.0 : 2.0; };
  EXPECT_EQ(distancesOf(far, growing(far, doubling)).back(), 1);
  EXPECT_GT(distancesOf(near, growing(near, doubling)).back(), 1.8);
}

TEST(CameraDistances, AreInProportionToTheBodiesOfPanelsIfAsked) {
  const std::string text =
      "[initial]\nangular_velocity = [5, 3, 1]\n[clip]\nduration = 1\n"
      "[[panel]]\nlabel = \"a\"\n[[panel]]\nlabel = \"b\"\nbody.shape = \"cards\"\n"
      "body.dimensions = { x = 0.0939, y = 0.145425, z = 0.025 }\n";
  const auto at = [](const scene::Scene& scene, std::size_t panel) {
    return CameraDistances(scene, simulateScene(scene)).at(panel, 7);
  };
  const scene::Scene all = scene::parseScene(text, "a.toml");
  EXPECT_EQ(at(all, 0), 1);
  EXPECT_EQ(at(all, 1), 1);
  for (const char* follow : {"none", "size"}) {
    const scene::Scene each = scene::parseScene(
        text, "a.toml",
        std::vector<std::string>{"camera.fit=each", std::string("camera.follow=") + follow});
    EXPECT_EQ(at(each, 0), 1);
    EXPECT_NEAR(at(each, 1), 0.5, 1e-12);  // half as large in each direction; measured 0
    EXPECT_EQ(distanceAtRest(each, 1), at(each, 1));
  }
}

TEST(CameraDistances, GoOnWhileTheLastPictureIsHeld) {
  const ClipMotion motion = growing(kFollowing, exploding, true);
  const std::vector<double> distances = distancesOf(kFollowing, motion);
  ASSERT_EQ(distances.size(), kFrames + 60U);
  EXPECT_GT(distances[kFrames + 30], distances[kFrames - 1]);
  EXPECT_EQ(distances[kFrames + 40], distances.back());
}

}  // namespace
}  // namespace rotatebook::timeline
