// The camera of a scene.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/camera.h"
#include "scene/scene.h"

namespace rotatebook::timeline {

/// Returns the camera of the scene's first frame for `screen`, the whole picture or a panel, at the
/// distance that the scene states.
geometry::Camera cameraOf(const scene::Scene& scene, const geometry::Screen& screen);

/// The camera's place and direction from frame to frame: that of the scene, and the moves of its
/// cues, each from where the camera is when it begins, by Hermite's 3 t^2 - 2 t^3. The camera goes
/// round its target, along its azimuth, elevation and distance.
class CameraPath {
 public:
  CameraPath(const scene::Scene& scene, const geometry::Screen& screen);

  bool moves() const { return !moves_.empty(); }
  /// Returns the camera in `frame` >= 0; cameraOf() bit by bit before it moves.
  geometry::Camera at(std::int64_t frame) const;

 private:
  /// A view, about the axis `up` through the target.
  struct View {
    Eigen::Vector3d target;  // [m]
    double azimuth;          // from the first view's, to the right [rad]
    double elevation;        // [rad]
    double distance;         // [m]
    double fieldOfViewDeg;   // [degrees]
  };
  struct Move {
    double frame, frames;  // its first one, and its length
    View from, to;
  };

  View viewFrom(const Eigen::Vector3d& position, const Eigen::Vector3d& target,
                double fieldOfViewDeg) const;
  View after(const View& before, const scene::CameraMove& move) const;
  Eigen::Vector3d positionOf(const View& view) const;
  View viewAt(double frame) const;

  geometry::Camera start_;
  geometry::Screen screen_;
  bool isPanel_;
  Eigen::Vector3d ahead_, right_, up_;  // axes of azimuth and elevation
  View first_;
  std::vector<Move> moves_;  // in the order of time
};

}  // namespace rotatebook::timeline
