// From the world to the picture.
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "physics/cuboid.h"
#include "render/antialias/hull_bands.h"

namespace rotatebook::render {

/// A perspective camera.
struct Camera {
  Eigen::Vector3d position{0, 0, 1};  ///< World. [m]
  Eigen::Vector3d target{0, 0, 0};  ///< The point in the middle of the picture; not `position`. [m]
  Eigen::Vector3d up{0, 1, 0};      ///< Not along the view.
  double fieldOfViewDeg = 30;       ///< Vertical, over 0 to under 180. [degrees]
};

/// One frame's projection.
struct Projection {
  /// World to clip space. Clip y points down, so that a frame buffer's first row is the picture's
  /// top.
  Eigen::Matrix4d clipFromWorld;
  /// The pixels that the hull of the points can touch, with a margin; the whole picture if a point
  /// is not in front of the camera; empty if the hull is beside the picture.
  PixelRect bounds;
  /// The same more closely, as rectangles one below the other.
  std::vector<PixelRect> bands;
};

/// Camera coordinates: x right, y up, z toward the viewer.
Eigen::Matrix4d viewFromWorld(const Camera& camera);

/// A picture, and how much of it the camera has.
struct Screen {
  int width = 0;       ///< > 0 [pixels]
  int height = 0;      ///< > 0 [pixels]
  int bottomRows = 0;  ///< The camera's picture ends above them; 0 to below `height`. [pixels]
};

/// Projects `points` (world) onto `screen`.
Projection project(const Camera& camera, const physics::Cage& points, const Screen& screen);

}  // namespace rotatebook::render
