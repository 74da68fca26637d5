// From the world to the picture's pixels. Inside the room only.
#pragma once

#include <optional>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "overlay/box.h"

namespace rotatebook::overlay {

/// A perspective view of the world.
class Projector {
 public:
  /// World to clip space, y down; only its rows of x, y and w are used. The picture's size is in
  /// pixels.
  Projector(const Eigen::Matrix4d& clipFromWorld, int width, int height)
      : clipFromWorld_(clipFromWorld), size_(width, height) {}

  /// Where `point` shows, perhaps outside the picture; nothing if it is not in front of the camera.
  std::optional<Point> operator()(const Eigen::Vector3d& point) const {
    const Eigen::Vector4d clip = clipFromWorld_ * point.homogeneous();
    if (!(clip.w() > 1e-6)) return std::nullopt;
    const Point unit = clip.head<2>() / clip.w();
    if (!unit.allFinite()) return std::nullopt;
    return ((unit.array() + 1) / 2 * size_.array()).matrix();
  }

  /// Where the camera is: the one point that has no x, y and w.
  Eigen::Vector3d eye() const {
    Eigen::Matrix3d directions;
    directions << clipFromWorld_.block<2, 3>(0, 0), clipFromWorld_.block<1, 3>(3, 0);
    const Eigen::Vector3d offsets(clipFromWorld_(0, 3), clipFromWorld_(1, 3), clipFromWorld_(3, 3));
    return -directions.inverse() * offsets;
  }

 private:
  Eigen::Matrix4d clipFromWorld_;
  Eigen::Vector2d size_;
};

}  // namespace rotatebook::overlay
