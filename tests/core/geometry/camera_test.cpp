#include "geometry/camera.h"

#include <cmath>

#include <gtest/gtest.h>

namespace rotatebook::geometry {
namespace {

const Eigen::Vector3d kX = Eigen::Vector3d::UnitX();
const Eigen::Vector3d kY = Eigen::Vector3d::UnitY();
const Eigen::Vector3d kZ = Eigen::Vector3d::UnitZ();

body::Cage book() {
  return body::Cuboid{}.corners();
}

constexpr double kRounding = 1e-9;  // measured 2e-14 pixels

Eigen::Vector2d pixelOf(const Projection& projection, const Eigen::Vector3d& world, int width,
                        int height) {
  const Eigen::Vector4d clip = projection.clipFromWorld * world.homogeneous();
  return {(clip.x() / clip.w() + 1) / 2 * width, (clip.y() / clip.w() + 1) / 2 * height};
}

// 2 m before the origin with a field of view of 90 degrees: half the picture's height is 2 m there.
Camera plainCamera() {
  return {.position = {0, 0, 2}, .target = {0, 0, 0}, .up = {0, 1, 0}, .fieldOfViewDeg = 90};
}

void expectNear(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  EXPECT_NEAR(a.x(), b.x(), kRounding);
  EXPECT_NEAR(a.y(), b.y(), kRounding);
}

TEST(Camera, PutsItsTargetInTheMiddle) {
  const Projection projection = project(plainCamera(), book(), {200, 100});
  expectNear(pixelOf(projection, {0, 0, 0}, 200, 100), {100, 50});
}

TEST(Camera, HasXToTheRightAndYUpward) {
  const Projection projection = project(plainCamera(), book(), {200, 100});
  // 50 pixels for 2 m, in both directions.
  expectNear(pixelOf(projection, {1, 0, 0}, 200, 100), {125, 50});
  expectNear(pixelOf(projection, {0, 1, 0}, 200, 100), {100, 25});
  expectNear(pixelOf(projection, {-2, -2, 0}, 200, 100), {50, 100});
}

TEST(Camera, ShowsWhatIsNearerLarger) {
  const Projection projection = project(plainCamera(), book(), {200, 100});
  expectNear(pixelOf(projection, {0.5, 0.5, 1}, 200, 100), {125, 25});
}

TEST(Camera, ShowsTheFieldOfViewFromTopToBottom) {
  Camera camera = plainCamera();
  camera.fieldOfViewDeg = 30;
  const Projection projection = project(camera, book(), {160, 90});
  const double halfHeight = 2 * 0.26794919243112270;  // tan(15 degrees)
  expectNear(pixelOf(projection, {0, halfHeight, 0}, 160, 90), {80, 0});
  expectNear(pixelOf(projection, {halfHeight, -halfHeight, 0}, 160, 90), {125, 90});
}

TEST(Camera, LooksFromItsPositionToItsTarget) {
  // From +x with z up: y is to the right, z upward.
  const Camera camera{.position = {3, 1, 1}, .target = {1, 1, 1}, .up = kZ, .fieldOfViewDeg = 90};
  const Projection projection = project(camera, book(), {100, 100});
  expectNear(pixelOf(projection, {1, 1, 1}, 100, 100), {50, 50});
  expectNear(pixelOf(projection, {1, 2, 1}, 100, 100), {75, 50});
  expectNear(pixelOf(projection, {1, 1, 2}, 100, 100), {50, 25});
}

TEST(Camera, TakesAnUpThatIsNotSquareToTheView) {
  Camera camera = plainCamera();
  camera.up = {0, 0.1, 5};
  const Eigen::Matrix4d view = viewFromWorld(camera);
  EXPECT_NEAR((view * kY.homogeneous() - Eigen::Vector4d(0, 1, -2, 1)).norm(), 0, kRounding);
  EXPECT_NEAR((view * kX.homogeneous() - Eigen::Vector4d(1, 0, -2, 1)).norm(), 0, kRounding);
}

TEST(Camera, OrdersDepthFromNearToFar) {
  const Projection projection = project(plainCamera(), book(), {200, 100});
  const auto depth = [&](double z) {
    const Eigen::Vector4d clip = projection.clipFromWorld * Eigen::Vector4d(0, 0, z, 1);
    return clip.z() / clip.w();
  };
  EXPECT_LT(depth(1), depth(0));
  EXPECT_GT(depth(1.9), -1);
  EXPECT_LT(depth(-0.025), 1) << "the book's far side is cut off";
}

TEST(CameraBounds, HoldTheHullWithAMargin) {
  // The near side decides: 25 pixels a metre at 2 m, the margin 6 pixels.
  body::Cage cube = body::Cuboid{.size = {2, 1, 1}}.corners();
  cube.row(2).array() -= 0.5;  // The near side at z = 0.
  const PixelRect expected{75 - 6, 50 - 13 - 6, 50 + 12, 26 + 12};
  EXPECT_EQ(project(plainCamera(), cube, {200, 100}).bounds, expected);
}

TEST(CameraBounds, StayInThePicture) {
  const body::Cage corners = body::Cuboid{.size = {20, 1, 1}}.corners();
  const PixelRect bounds = project(plainCamera(), corners, {200, 100}).bounds;
  EXPECT_EQ(bounds.x, 0);
  EXPECT_EQ(bounds.width, 200);
  EXPECT_LT(bounds.height, 100);
}

TEST(CameraBounds, AreTheWholePictureForAPointNotBeforeTheCamera) {
  const PixelRect whole{0, 0, 200, 100};
  for (const double z : {2.0, 2.5, 100.0}) {
    body::Cage corners = book();
    corners.col(3) = Eigen::Vector3d(0.1, 0.1, z);
    EXPECT_EQ(project(plainCamera(), corners, {200, 100}).bounds, whole) << "at z = " << z;
  }
}

TEST(CameraBounds, AreEmptyBesideThePicture) {
  for (const Eigen::Vector3d& place :
       {Eigen::Vector3d(9, 0, 0), Eigen::Vector3d(-9, 0, 0), Eigen::Vector3d(0, 9, 0),
        Eigen::Vector3d(0, -9, 0), Eigen::Vector3d(1e30, 0, 0)}) {
    const body::Cage beside = book().colwise() + place;
    const PixelRect bounds = project(plainCamera(), beside, {200, 100}).bounds;
    EXPECT_EQ(bounds.width * bounds.height, 0) << place.transpose();
  }
}

// With half of the rows left to others the picture is that of a screen half as high.
TEST(Project, LeavesTheBottomRowsToOthers) {
  const Projection half = project(plainCamera(), book(), {200, 100, 50});
  const Projection low = project(plainCamera(), book(), {200, 50});
  EXPECT_EQ(half.bounds, low.bounds);
  const Eigen::Vector4d corner(0.05, -0.1, 0.02, 1);
  const Eigen::Vector4d here = half.clipFromWorld * corner;
  const Eigen::Vector4d there = low.clipFromWorld * corner;
  EXPECT_NEAR(here.x() / here.w(), there.x() / there.w(), 1e-12);  // measured 0
  EXPECT_NEAR((here.y() / here.w() + 1) * 100, (there.y() / there.w() + 1) * 50, 1e-10);  // 0
}

}  // namespace
}  // namespace rotatebook::geometry
