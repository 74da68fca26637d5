// The turning of a body as keys of an animation. Inside the room only.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "body/cuboid.h"
#include "scene/scene.h"

namespace rotatebook::interchange {

inline constexpr double kCloseDeg = 0.05;  ///< Nobody sees less.
inline constexpr int kMostKeys = 960;      ///< A second of the video, unless more are asked for.

/// The keys of an animation.
struct KeyOptions {
  /// Of the video, 1 to 1000. By default 60, and twice as many, up to 960, while the motion is more
  /// than kCloseDeg off between them.
  std::optional<int> keysPerSecond{};
  /// Writes CUBICSPLINE, with the tangents that follow from the angular velocity, in place of
  /// LINEAR, which is what all programs read.
  bool tangents = false;
};

/// A moment of an animation.
struct Key {
  double time = 0;                          ///< Of the video. [s]
  Eigen::Quaterniond attitude{1, 0, 0, 0};  ///< World from body; its sign is continuous.
  Eigen::Quaterniond tangent{0, 0, 0, 0};   ///< Its derivative by the video's time. [1/s]
  /// Displacements of the corners from those of the rigid body, along its axes. [m]
  body::Cage displacements = body::Cage::Zero();
};

/// An animation, from the clip's first frame to its last.
struct Turning {
  int keysPerSecond = 0;    ///< Of the video.
  std::vector<Key> keys{};  ///< In the order of time; one or more, the first at 0.
  /// The largest displacement along an axis, of a body that deforms: a corner moves by more than
  /// kCloseDeg, as seen from the centre. [m]
  std::optional<double> reach{};
  /// The most that it is off the motion halfway between two keys. Of a body that deforms, that is a
  /// corner as seen from the centre.
  double errorDeg = 0;
  double errorM = 0;  ///< Likewise of a corner. [m]
};

/// Returns the turning of the scene's only motion in `frames` >= 1 frames. Halfway between keys,
/// attitude and corners are measured as viewers interpolate them.
Turning turningOf(const scene::Scene& scene, std::int64_t frames, const KeyOptions& options);

}  // namespace rotatebook::interchange
