// Which stage limits the speed of a render, and what would raise it.
#pragma once

#include <string>
#include <vector>

#include "diagnose/benchmark.h"
#include "scene/scene.h"

namespace rotatebook::diagnose {

enum class Stage { Simulate, Book, Finish, Png, Video };

/// What keeps a render from being faster.
struct SpeedLimit {
  Stage stage = Stage::Book;
  /// Whether all cores are busy, most of all with `stage`; else `stage` alone takes so long, on its
  /// one thread or its graphics card, that the others wait for it.
  bool ofCores = true;
  double wall = 0;  ///< The least time a frame that these stages allow. [ms]
};

/// What holds for stages that take turns on `cores` >= 1 cores without ever waiting: no frame takes
/// less than all processor time shared out, or than the stages that see one frame after the other,
/// book, finish and video, take alone.
SpeedLimit speedLimit(const StageTimes& stages, int cores);

/// Something to change, and what comes of it.
struct SpeedAdvice {
  std::string change;  ///< For example "--no-png".
  std::string effect;  ///< What it costs, or why it helps.
  double gain = 1;     ///< Frames a second, at most, as a multiple of those now.
};

/// What would help the stage that limits, with the gain that the measured times let expect; only
/// what gains at least 3 %, the greatest gain first.
std::vector<SpeedAdvice> speedAdvice(const scene::Scene& scene, const Speed& speed);

}  // namespace rotatebook::diagnose
