// The body as something that hides what is behind it. Inside the room only.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "overlay/canvas.h"
#include "overlay/drawn_overlay.h"
#include "physics/cuboid.h"

namespace rotatebook::overlay {

/// The skewed box that fits a deformed body best.
class BodyBox {
 public:
  BodyBox(const physics::Cuboid& body, const physics::Cage& cage);

  /// From the axes of the undeformed body: a rotation where it isn't deformed.
  const Eigen::Matrix3d& map() const { return map_; }
  const Eigen::Vector3d& centre() const { return centre_; }
  /// Whether a camera at `eye` can't see `point` because it is in or behind the box.
  bool hides(const Eigen::Vector3d& point, const Eigen::Vector3d& eye) const;

 private:
  Eigen::Matrix3d map_;
  Eigen::Vector3d centre_;
  Eigen::Matrix3d boxFromWorld_;  // to where the box reaches from -1 to 1
};

/// A straight line in the world, faint where the body hides it. Ends that aren't in front of the
/// camera draw nothing.
void drawLine(const View& view, const BodyBox& box, const Eigen::Vector3d& from,
              const Eigen::Vector3d& to, const Pen& pen);

/// How an arrow that begins within the body lies on the picture, unless an end isn't in front of
/// the camera.
std::optional<ArrowShape> arrowShape(const Projector& projector, const BodyBox& box,
                                     const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                     const Pen& pen);

/// Draws it, faint where the body hides it.
void drawArrow(const View& view, const BodyBox& box, const Eigen::Vector3d& from,
               const Eigen::Vector3d& to, const Pen& pen);

}  // namespace rotatebook::overlay
