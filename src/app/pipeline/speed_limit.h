// The stage that limits a render's speed, and what would raise it.
#pragma once

#include <string>
#include <vector>

#include "pipeline/benchmark.h"
#include "scene/scene.h"

namespace rotatebook::pipeline {

/// The stages of a render; Compose: edges, background, overlays.
enum class Stage { Simulate, Book, Compose, Png, Video };

/// The limit of a render's speed.
struct SpeedLimit {
  Stage stage = Stage::Book;
  /// True if all cores are busy, most of all with `stage`; false if `stage`, on its one thread or
  /// its graphics card, takes so long that the others wait for it.
  bool ofCores = true;
  double wall = 0;  ///< The shortest time a frame that the stages allow. [ms]
};

/// Returns the limit for stages that share `cores` >= 1 cores without ever waiting: a frame takes
/// at least the stages' processor time divided by `cores`, and at least as long as each of the
/// stages that take one frame after the other: book, finish and video.
SpeedLimit speedLimit(const StageTimes& stages, int cores);

/// A change that would make a render faster.
struct SpeedAdvice {
  std::string change;  ///< For example "--no-png".
  std::string effect;  ///< Its cost, or why it helps.
  double gain = 1;     ///< Upper bound of the speed-up, as a factor.
};

/// Returns what would help the stage that limits, with the gain calculated from the measured times;
/// only what gains at least 3 %, the largest gain first.
std::vector<SpeedAdvice> speedAdvice(const scene::Scene& scene, const Speed& speed);

}  // namespace rotatebook::pipeline
