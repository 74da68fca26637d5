// Simulates the motions of a scene, in slices or as a whole.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "physics/simulate.h"
#include "scene/scene.h"
#include "timeline/clip_motion.h"

namespace rotatebook::timeline {

/// Returns the times of the clip's frames, each followed by those of `parts` - 1 >= 0 moments that
/// divide the frame evenly. [s]
std::vector<double> frameTimes(const scene::Scene& scene, int parts = 1);

/// A scene's motions, in the order of Scene::motions, simulated frame by frame. What is thrown
/// is as in physics::Simulation; an InputError names the scene's file and panel, too. In a grid a
/// motion whose step can't be made ends there, like one that diverges, and the others go on.
class SceneSimulation {
 public:
  /// Simulates the first frame.
  explicit SceneSimulation(const scene::Scene& scene);

  /// Simulates the next frame of every motion that hasn't diverged; none once isComplete().
  void advance();
  /// Returns whether all motions have diverged or reached the clip's end.
  bool isComplete() const;
  /// Takes the names for messages from a scene with the same motions.
  void takeNames(const scene::Scene& scene);
  /// Returns the number of frames so far, >= 1.
  std::int64_t frames() const { return frames_; }
  /// Returns the samples so far of one motion; valid as long as this object.
  const physics::Trajectory& trajectory(std::size_t motion) const {
    return simulations_[motion].trajectory();
  }
  /// Returns the clip's motion, as far as it is simulated.
  ClipMotion motion() const;

 private:
  FrameRate rate_;
  std::vector<double> times_;
  std::vector<std::string> names_;  // of the motions, for messages
  std::vector<physics::Simulation> simulations_;
  bool isGrid_;
  /// The times of steps that couldn't be made. [s]
  std::vector<std::optional<double>> refusedAt_;
  std::int64_t frames_ = 1;
};

/// Simulates all motions of the scene's clip. `stop` is as in physics::simulate(); throws as
/// SceneSimulation does.
ClipMotion simulateScene(const scene::Scene& scene, const std::atomic<bool>* stop = nullptr);

}  // namespace rotatebook::timeline
