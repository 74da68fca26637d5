#include "render/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rotatebook::render {
namespace {

constexpr double kNearPlane = 0.01;  // Of the distance to the target.
constexpr int kMarginPixels = 2;     // Rounding and antialiasing reach this far at most.

Eigen::Matrix4d clipFromView(const Camera& camera, double aspect, double near, double far) {
  const double scale = 1 / std::tan(camera.fieldOfViewDeg * std::numbers::pi / 360);
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  matrix(0, 0) = scale / aspect;
  matrix(1, 1) = -scale;
  matrix(2, 2) = (far + near) / (near - far);
  matrix(2, 3) = 2 * far * near / (near - far);
  matrix(3, 2) = -1;
  return matrix;
}

/// From the whole picture to the upper share of it.
Eigen::Matrix4d upperShare(double share) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix(1, 1) = share;
  matrix(1, 3) = share - 1;
  return matrix;
}

/// The pixels from `low` to `high` (in -1 to 1) of `size`, as first and one past the last.
std::pair<int, int> pixelSpan(double low, double high, int size) {
  const auto toPixel = [size](double clip) {
    return std::clamp((clip + 1) / 2 * size, -1.0 * size, 2.0 * size);
  };
  const int first = static_cast<int>(std::floor(toPixel(low))) - kMarginPixels;
  const int end = static_cast<int>(std::ceil(toPixel(high))) + kMarginPixels;
  return {std::clamp(first, 0, size), std::clamp(end, 0, size)};
}

PixelRect boundsOf(const Eigen::Matrix<double, 4, 8>& clip, double near, int width, int height) {
  if (clip.row(3).minCoeff() <= near) return {0, 0, width, height};
  const Eigen::Array<double, 1, 8> x = clip.row(0).array() / clip.row(3).array();
  const Eigen::Array<double, 1, 8> y = clip.row(1).array() / clip.row(3).array();
  const auto [left, right] = pixelSpan(x.minCoeff(), x.maxCoeff(), width);
  const auto [top, bottom] = pixelSpan(y.minCoeff(), y.maxCoeff(), height);
  return {left, top, right - left, bottom - top};
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

Projection project(const Camera& camera, const physics::Corners& points, const Screen& screen) {
  const Eigen::Matrix4d view = viewFromWorld(camera);
  const Eigen::Matrix<double, 4, 8> viewPoints = view * points.colwise().homogeneous();
  const double near = kNearPlane * (camera.position - camera.target).norm();
  const double far = std::max(2 * near, 1.01 * -viewPoints.row(2).minCoeff());
  const double share = 1 - static_cast<double>(screen.bottomRows) / screen.height;
  const double aspect = screen.width / (share * screen.height);
  const Eigen::Matrix4d clipFromWorld =
      upperShare(share) * clipFromView(camera, aspect, near, far) * view;
  const Eigen::Matrix<double, 4, 8> clip = clipFromWorld * points.colwise().homogeneous();
  return {clipFromWorld, boundsOf(clip, near, screen.width, screen.height)};
}

}  // namespace rotatebook::render
