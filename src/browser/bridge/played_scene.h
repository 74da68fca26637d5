// A scene that is simulated in slices while it is played. Inside the room only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <vector>

#include "geometry/camera.h"
#include "scene/scene.h"
#include "timeline/camera_distances.h"
#include "timeline/clip_motion.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::bridge {

/// Turns of the camera about its target: to the right about `up`, then up. [rad]
struct Orbit {
  double right = 0;
  double up = 0;
  double distance = 1;  ///< Multiple of its distance from the target, > 0.
};

/// A scene with its motions, as far as they are simulated.
class PlayedScene {
 public:
  /// Simulates the first frame. Throws InputError as timeline::SceneSimulation does, and if the
  /// motions have more than `maxFrames` frames together.
  PlayedScene(scene::Scene scene, std::int64_t maxFrames);

  const scene::Scene& scene() const { return scene_; }

  /// Returns whether `scene` has the same motions on the same clock, and they haven't failed.
  bool hasMotionsOf(const scene::Scene& scene) const;
  /// Takes `scene`, of which hasMotionsOf() is true, in place of its own, and keeps the samples.
  void replace(scene::Scene scene);

  /// Simulates up to and including `frame`, or about `steps` integration steps, at least one frame.
  /// Returns the number of frames so far. Throws StepError, and the same one ever after.
  std::int64_t advance(std::int64_t frame, std::int64_t steps);
  /// Returns the motion, if it is simulated to its end; else null.
  const timeline::ClipMotion* whole() const { return whole_ ? &*whole_ : nullptr; }
  /// Returns the frames of the clip, as far as it is known how many there are.
  std::int64_t frameCount() const;

  /// Returns the sample that `frame` shows, along the axes of the scene's camera: the last one so
  /// far, if the motion has diverged before or isn't simulated up to there. Throws
  /// std::out_of_range if there is no such motion, as the two below do.
  physics::Sample sample(std::size_t motion, std::int64_t frame) const;
  /// Returns the motion's samples so far, in the world, and the index of the one that `frame`
  /// shows.
  const std::vector<physics::Sample>& samples(std::size_t motion) const;
  std::size_t indexOf(std::size_t motion, std::int64_t frame) const;
  /// Returns the reference frame in which the camera sees a motion.
  const scene::MotionFrame& frameOf(std::size_t motion) const { return frames_.at(motion); }
  /// Returns whether the camera turns or moves before what stands still in the world.
  bool turns() const;
  /// Returns whether a motion has diverged by `frame`.
  bool isHeld(std::size_t motion, std::int64_t frame) const;
  /// Returns the scene's camera in `frame`, or the nearest that there is, turned by `orbit`.
  geometry::Camera camera(std::size_t motion, std::int64_t frame, const geometry::Screen& screen,
                          const Orbit& orbit) const;

 private:
  std::int64_t stepsOfFrame() const;
  void simulate(std::int64_t frame, std::int64_t steps);
  const physics::Trajectory& trajectory(std::size_t motion) const;

  scene::Scene scene_;
  std::size_t motionCount_;
  std::vector<scene::MotionFrame> frames_;               // of the camera, by motion
  std::optional<timeline::SceneSimulation> simulation_;  // until its samples are in `whole_`
  std::exception_ptr failure_;
  std::optional<timeline::ClipMotion> whole_;
  std::optional<timeline::CameraDistances> distances_;
};

}  // namespace rotatebook::bridge
