// The body as a box that hides what is behind it. Inside the room only.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "overlay/canvas.h"
#include "overlay/drawn_overlay.h"
#include "physics/sample.h"

namespace rotatebook::overlay {

/// The parallelepiped that fits a deformed body best.
class BodyBox {
 public:
  BodyBox(const body::Cuboid& body, const body::Cage& cage);

  /// Returns the linear part of the deformation: a rotation if the body isn't deformed.
  const Eigen::Matrix3d& map() const { return map_; }
  const Eigen::Vector3d& centre() const { return centre_; }
  /// Returns whether `point` is invisible to a camera at `eye` because it is in or behind the box.
  bool hides(const Eigen::Vector3d& point, const Eigen::Vector3d& eye) const;
  /// Returns the corners of the sides that face a camera at `eye`, each once round.
  std::vector<std::vector<Eigen::Vector3d>> sidesFacing(const Eigen::Vector3d& eye) const;

 private:
  Eigen::Matrix3d map_;
  Eigen::Vector3d centre_;
  Eigen::Matrix3d worldFromBox_;  // from coordinates in which the box reaches from -1 to 1
  Eigen::Matrix3d boxFromWorld_;
};

/// Projects an arrow that begins within the body; nothing if an end isn't in front of the camera.
std::optional<ArrowShape> arrowShape(const Projector& projector, const BodyBox& box,
                                     const Arrow& arrow);

/// Draws an arrow that begins within the body, faint where the body hides it.
void drawArrow(const View& view, const BodyBox& box, const Arrow& arrow);

}  // namespace rotatebook::overlay
