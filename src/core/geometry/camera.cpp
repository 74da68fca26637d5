#include "geometry/camera.h"

#include <algorithm>
#include <numbers>

#include <Eigen/LU>

#include "base/elementary.h"

namespace rotatebook::geometry {
namespace {

constexpr double kNearPlane = 0.01;  // Share of the distance to the target.

Eigen::Matrix4d clipFromView(const Camera& camera, double aspect, double near, double far) {
  const double half = camera.fieldOfViewDeg * std::numbers::pi / 360;
  const double scale = cosine(half) / sine(half);
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  matrix(0, 0) = scale / aspect;
  matrix(1, 1) = -scale;
  matrix(2, 2) = (far + near) / (near - far);
  matrix(2, 3) = 2 * far * near / (near - far);
  matrix(3, 2) = -1;
  return matrix;
}

/// Returns the transform from the whole picture to its upper share.
Eigen::Matrix4d toUpperShare(double share) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix(1, 1) = share;
  matrix(1, 3) = share - 1;
  return matrix;
}

/// Projects clip-space points, all in front of the camera, onto a picture. [pixels]
PicturePoints onPicture(const Eigen::Matrix<double, 4, 8>& clip, int width, int height) {
  PicturePoints points = clip.topRows<2>().array().rowwise() / clip.row(3).array();
  points.row(0) = (points.row(0).array() + 1) / 2 * width;
  points.row(1) = (points.row(1).array() + 1) / 2 * height;
  return points;
}

}  // namespace

Eigen::Matrix4d viewFromWorld(const Camera& camera) {
  const Eigen::Vector3d back = (camera.position - camera.target).normalized();
  const Eigen::Vector3d right = camera.up.cross(back).normalized();
  Eigen::Matrix3d rotation;
  rotation << right.transpose(), back.cross(right).transpose(), back.transpose();
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = rotation;
  matrix.topRightCorner<3, 1>() = -rotation * camera.position;
  return matrix;
}

Camera movedAway(Camera camera, double multiple) {
  // The detour by the target would round a position that stays.
  if (multiple != 1) camera.position = camera.target + multiple * (camera.position - camera.target);
  return camera;
}

Projection project(const Camera& camera, const body::Cage& points, const Screen& screen) {
  const Eigen::Matrix4d view = viewFromWorld(camera);
  const Eigen::Matrix<double, 4, 8> viewPoints = view * points.colwise().homogeneous();
  // Fit the depth range to the points
  const double near = kNearPlane * (camera.position - camera.target).norm();
  const double far = std::max(2 * near, 1.01 * -viewPoints.row(2).minCoeff());

  // Project into the viewport above the bottom rows
  const double share = 1 - static_cast<double>(screen.bottomRows) / screen.height;
  const double aspect = screen.width / (share * screen.height);
  const Eigen::Matrix4d clipFromWorld =
      toUpperShare(share) * clipFromView(camera, aspect, near, far) * view;
  const Eigen::Matrix<double, 4, 8> clip = clipFromWorld * points.colwise().homogeneous();

  // Bound the pixels
  if (clip.row(3).minCoeff() <= near) {
    const PixelRect all{0, 0, screen.width, screen.height};
    return {clipFromWorld, all, {all}};
  }
  const PicturePoints onScreen = onPicture(clip, screen.width, screen.height);
  const PixelRect bounds = boundsOf(onScreen, screen.width, screen.height);
  return {clipFromWorld, bounds, hullBands(onScreen, bounds)};
}

Eigen::Matrix4d skyFromPicture(const Camera& camera, const Screen& screen,
                               const Eigen::Matrix3d& worldFromFrame) {
  // The depth range, which follows the points, isn't in the rows that are used
  const Eigen::Matrix4d clip = project(camera, body::Cage::Zero(), screen).clipFromWorld;
  Eigen::Matrix3d clipFromDirection;
  clipFromDirection << clip.block<2, 3>(0, 0), clip.block<1, 3>(3, 0);
  const double shorter = std::min(screen.width, screen.height);
  const Eigen::Vector3d clipFromPicture(shorter / screen.width, shorter / screen.height, 1);
  Eigen::Matrix4d sky = Eigen::Matrix4d::Identity();
  sky.topLeftCorner<3, 3>() =
      worldFromFrame * clipFromDirection.inverse() * clipFromPicture.asDiagonal();
  return sky;
}

}  // namespace rotatebook::geometry
