// Projects points of the world to pixels. Inside the room only.
#pragma once

#include <optional>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "overlay/box.h"

namespace rotatebook::overlay {

/// A perspective projection from the world onto a picture.
class Projector {
 public:
  /// Takes the matrix from world to clip space, y down, of which only the rows of x, y and w are
  /// used, and the picture's size. [pixels]
  Projector(const Eigen::Matrix4d& clipFromWorld, int width, int height)
      : clipFromWorld_(clipFromWorld), size_(width, height) {}

  /// Projects `point`, perhaps to outside the picture; nothing if it isn't in front of the camera.
  std::optional<Point> operator()(const Eigen::Vector3d& point) const {
    const Eigen::Vector4d clip = clipFromWorld_ * point.homogeneous();
    if (!(clip.w() > 1e-6)) return std::nullopt;
    const Point unit = clip.head<2>() / clip.w();
    if (!unit.allFinite()) return std::nullopt;
    return ((unit.array() + 1) / 2 * size_.array()).matrix();
  }

  /// Returns the camera's position: the one point whose x, y and w are 0.
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
