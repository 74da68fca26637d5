#include "scene/scene.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/poster_frame.h"
#include "scene/scene_text.h"

namespace rotatebook::scene {
namespace {

struct View {
  int width;
  int height;
  double fieldOfViewDeg;
};

constexpr View kViews[] = {{1280, 720, 30}, {720, 1280, 30}, {640, 640, 30},  {1920, 160, 30},
                           {160, 1920, 30}, {1280, 720, 1},  {1280, 720, 120}};

Eigen::Quaterniond randomAttitude(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
  return Eigen::Quaterniond(w, x, y, z).normalized();
}

/// The point's distance from the picture's middle, 1 at its edge, along width and height.
Eigen::Array2d projected(const Eigen::Vector3d& point, const Eigen::Vector3d& camera,
                         const View& view) {
  const Eigen::Vector3d back = camera.normalized();
  const Eigen::Vector3d right = Eigen::Vector3d::UnitY().cross(back).normalized();
  const Eigen::Vector3d up = back.cross(right);
  const Eigen::Vector3d seen = point - camera;
  const double halfHeight =
      -seen.dot(back) * std::tan(view.fieldOfViewDeg / 2 * std::numbers::pi / 180);
  const double halfWidth = halfHeight * view.width / view.height;
  return {std::abs(seen.dot(right)) / halfWidth, std::abs(seen.dot(up)) / halfHeight};
}

/// The farthest that a corner gets from the middle in many attitudes.
double farthestCorner(const body::Cuboid& body, const View& view) {
  const Eigen::Vector3d camera =
      defaultCameraPosition(body, view.fieldOfViewDeg, view.width, view.height);
  std::mt19937 random(1);
  double farthest = 0;
  for (int i = 0; i < 500; ++i) {
    const body::Cage corners = randomAttitude(random).toRotationMatrix() * body.corners();
    for (int c = 0; c < 8; ++c) {
      farthest = std::max(farthest, projected(corners.col(c), camera, view).maxCoeff());
    }
  }
  return farthest;
}

TEST(DefaultCamera, ShowsAllOfTheBodyInAnyAttitudeAndLarge) {
  // Measured 0.774 at 120 degrees, where the near corners gain most, and 0.91 and more at 30.
  constexpr double kLargestAtLeast = 0.76;
  for (const Eigen::Vector3d& size : {Eigen::Vector3d(0.1878, 0.29085, 0.05),
                                      Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(0.01, 30, 2)}) {
    for (const View& view : kViews) {
      const double farthest = farthestCorner({.size = size, .mass = 1}, view);
      EXPECT_LT(farthest, 1) << view.width << "x" << view.height << " " << view.fieldOfViewDeg;
      EXPECT_GT(farthest, kLargestAtLeast)
          << view.width << "x" << view.height << " " << view.fieldOfViewDeg;
    }
  }
}

TEST(DefaultCamera, IsToTheRightAndAboveTheCover) {
  const Eigen::Vector3d position = defaultCameraPosition({}, 30, 1280, 720);
  EXPECT_TRUE(position.normalized().isApprox(Eigen::Vector3d(0.42, 0.30, 1).normalized()));
}

#if GTEST_HAS_DEATH_TEST
TEST(SceneDeathTest, OfAnotherSizeInAProgramIsRefused) {
  EXPECT_EXIT(
      {
        noteSize("scene::Scene", kSceneSize, sizeof(Scene) + 16);
        try {
          sceneText({});
        } catch (const InputError& error) {
          std::cerr << error.what();
          std::exit(1);
        }
        std::exit(0);
      },
      testing::ExitedWithCode(1), "rotatebook was built with a scene::Scene of ");
}
#endif

TEST(PosterFrame, IsInTheMiddleUnlessTheSceneSaysOtherwise) {
  ClipSettings clip;
  EXPECT_EQ(posterFrame(clip, 12), 6);
  EXPECT_EQ(posterFrame(clip, 1), 0);
  clip.poster = 0.05;
  EXPECT_EQ(posterFrame(clip, 12), 3);
  clip.poster = 0.055;  // 3.3 frames
  EXPECT_EQ(posterFrame(clip, 12), 3);
  clip.poster = 0.06;  // 3.6 frames
  EXPECT_EQ(posterFrame(clip, 12), 4);
  clip.poster = 99;
  EXPECT_EQ(posterFrame(clip, 12), 11);
}

}  // namespace
}  // namespace rotatebook::scene
