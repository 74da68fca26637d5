// A surface as it is seen from afar, in one direction. Inside the room only.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

namespace rotatebook::geometry {

/// Depths of a surface within the unit ball, as seen along parallel rays. A point's shadow is soft
/// over a pixel's width.
class DepthMap {
 public:
  static constexpr int kPixels = 256;  ///< Across the map.
  /// Distance from its surface at which a point is looked up: so far off, no slope shadows itself
  /// by the width of a pixel. [radii of the ball]
  static constexpr double kOffset = 1.5 * 2 / kPixels;

  /// Makes an empty map of what is seen from `direction`, of unit length.
  explicit DepthMap(const Eigen::Vector3d& direction);

  const Eigen::Vector3d& direction() const { return direction_; }

  /// Returns a point's place in the map [pixels], and its height toward the direction.
  Eigen::Vector3d placeOf(const Eigen::Vector3d& point) const;

  /// Draws a triangle between such places, unless it faces away.
  void draw(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

  /// Returns the share of a place that nothing above it hides. [0 to 1]
  double seenShare(const Eigen::Vector3d& place) const;

 private:
  /// The heights of a triangle's plane: `middle` + `slopes` * (place - `from`), within bounds.
  struct Plane {
    Eigen::Vector2d from, slopes;
    double height, lowest, highest;
  };
  void drawRow(int row, const std::array<Eigen::Vector3d, 3>& corners, const Plane& plane);

  Eigen::Vector3d direction_, across_, up_;
  std::vector<float> heights_;
};

}  // namespace rotatebook::geometry
