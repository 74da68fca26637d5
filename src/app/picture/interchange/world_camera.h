// The scene's camera in the world. Inside the room only.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "geometry/camera.h"
#include "physics/sample.h"
#include "scene/reference_frame.h"
#include "scene/scene.h"
#include "timeline/scene_camera.h"

namespace rotatebook::interchange {

/// A camera's place in the world.
struct CameraPlace {
  Eigen::Vector3d position;     ///< [m]
  Eigen::Quaterniond attitude;  ///< World from camera: x right, y up, z toward the viewer.
};

/// The camera of a motion, from frame to frame.
class WorldCamera {
 public:
  /// `scene` has the motion alone; `distances` are multiples of the camera's, one a frame.
  WorldCamera(const scene::Scene& scene, std::vector<double> distances);

  /// Returns whether it is animated.
  bool moves() const;
  /// Returns the width of the picture as a multiple of its height.
  double aspect() const { return aspect_; }
  /// Returns the angle of view at the start, from below to above. [rad]
  double fieldOfView() const;
  /// Returns the distance at which things begin to be seen. [m]
  double near() const;
  CameraPlace placeAt(std::int64_t frame, const physics::Sample& sample) const;

 private:
  geometry::Camera at(std::int64_t frame) const;

  timeline::CameraPath path_;
  scene::MotionFrame frame_;
  std::vector<double> distances_;
  double aspect_;
};

}  // namespace rotatebook::interchange
