// Projects the world onto the picture.
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "body/cuboid.h"
#include "geometry/hull_bands.h"

namespace rotatebook::geometry {

/// A perspective camera.
struct Camera {
  Eigen::Vector3d position{0, 0, 1};  ///< World. [m]
  Eigen::Vector3d target{0, 0, 0};    ///< Point in the middle of the picture; not `position`. [m]
  Eigen::Vector3d up{0, 1, 0};        ///< Direction; not parallel to the view.
  double fieldOfViewDeg = 30;         ///< Vertical, between 0 and 180. [degrees]
};

/// The projection of one frame.
struct Projection {
  /// Takes the world to clip space. Clip y points down, so that a frame buffer's first row is the
  /// picture's top.
  Eigen::Matrix4d clipFromWorld;
  /// The pixels that the points' convex hull can touch, with a margin. The whole picture if a point
  /// isn't in front of the camera; empty if the hull lies outside the picture.
  PixelRect bounds;
  /// A closer bound of the same pixels, as rectangles one below the other.
  std::vector<PixelRect> bands;
};

/// Returns the transform to camera coordinates: x right, y up, z toward the viewer.
Eigen::Matrix4d viewFromWorld(const Camera& camera);

/// The size of a picture, and the part of it that is the camera's viewport.
struct Screen {
  int width = 0;       ///< > 0 [pixels]
  int height = 0;      ///< > 0 [pixels]
  int bottomRows = 0;  ///< Below the viewport; 0 to below `height`. [pixels]
};

/// Returns `camera` at `multiple` > 0 of its distance from its target; at 1 it keeps its bits.
Camera movedAway(Camera camera, double multiple);

/// Projects `points` (world) onto `screen`.
Projection project(const Camera& camera, const body::Cage& points, const Screen& screen);

/// Returns what takes (x, y, 1, 1), from the middle of the picture in halves of its shorter side, y
/// down, to the direction in the world that is seen there. `camera` is in a frame of reference from
/// which `worldFromFrame` leads to the world.
Eigen::Matrix4d skyFromPicture(const Camera& camera, const Screen& screen,
                               const Eigen::Matrix3d& worldFromFrame);

}  // namespace rotatebook::geometry
