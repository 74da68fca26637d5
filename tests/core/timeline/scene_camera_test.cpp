#include "timeline/scene_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "scene/scene_text.h"

namespace rotatebook::timeline {
namespace {

using Eigen::Vector3d;

constexpr geometry::Screen kScreen{1280, 720, 0};
constexpr double kRounding = 1e-15;  // measured 4.5e-16

/// Returns the camera's path of a book that turns a radian in a second, at 60 frames in one.
CameraPath pathOf(const std::string& cues) {
  return CameraPath(
      scene::parseScene("[initial]\nangular_velocity = [1, 0, 0]\n[clip]\nduration = 12\n"
                        "[camera]\nposition = [0, 0.3, 0.4]\n" +
                            cues,
                        "a.toml"),
      kScreen);
}

void expectNear(const Vector3d& found, const Vector3d& expected) {
  EXPECT_LT((found - expected).norm(), kRounding) << found.transpose();
}

TEST(CameraPath, StaysWithoutMoves) {
  const CameraPath path = pathOf("");
  EXPECT_FALSE(path.moves());
  EXPECT_EQ(path.at(0).position, Vector3d(0, 0.3, 0.4));
  EXPECT_EQ(path.at(700).position, Vector3d(0, 0.3, 0.4));
}

TEST(CameraPath, OrbitsToTheRightAtOneHeight) {
  const CameraPath path = pathOf("[[cue]]\nat = 1\nmove = { orbit = \"90 deg\", over = 2 }\n");
  EXPECT_EQ(path.at(60).position, Vector3d(0, 0.3, 0.4));
  // After a quarter of the time 5/32 of the way, by 3 t^2 - 2 t^3
  const double angle = 5.0 / 32 * std::numbers::pi / 2;
  expectNear(path.at(90).position, {0.4 * std::sin(angle), 0.3, 0.4 * std::cos(angle)});
  expectNear(path.at(180).position, {0.4, 0.3, 0});
  expectNear(path.at(700).position, {0.4, 0.3, 0});
}

TEST(CameraPath, GoesRoundItsTargetToAStatedPlace) {
  const CameraPath path = pathOf(
      "[[cue]]\nat = 0\nmove = { position = [0.1, 0.3, -0.4], target = [0, 0.1, 0], "
      "field_of_view_deg = 50, over = 1 }\n");
  const geometry::Camera end = path.at(60);
  expectNear(end.position, {0.1, 0.3, -0.4});
  expectNear(end.target, {0, 0.1, 0});
  EXPECT_NEAR(end.fieldOfViewDeg, 50, 1e-14);          // measured 0
  EXPECT_NEAR(path.at(30).fieldOfViewDeg, 40, 1e-14);  // measured 0
  for (int frame = 0; frame <= 60; ++frame) {
    const geometry::Camera camera = path.at(frame);
    EXPECT_GT((camera.position - camera.target).norm(), 0.45) << frame;  // measured 0.458
    EXPECT_GE(camera.position.x(), -1e-15) << frame;  // the shorter way is by the right
  }
}

TEST(CameraPath, GoesOnFromWhereALaterMoveInterruptsIt) {
  const CameraPath path = pathOf(
      "[[cue]]\nat = 0\nmove = { orbit = 2, over = 4 }\n"
      "[[cue]]\nat = 2\nmove = { orbit = -3, over = 1 }\n");
  double largest = 0;
  for (int frame = 1; frame <= 300; ++frame)
    largest = std::max(largest, (path.at(frame).position - path.at(frame - 1).position).norm());
  EXPECT_LT(largest, 0.025);  // measured 0.02
  expectNear(path.at(180).position, {0.4 * std::sin(-1.0), 0.3, 0.4 * std::cos(-1.0)});
}

}  // namespace
}  // namespace rotatebook::timeline
