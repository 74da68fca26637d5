// Progress of a plan, as the files of its results show it. Inside the room only.
#pragma once

#include <cstdint>
#include <vector>

#include "farm/plan.h"
#include "farm/plan_file.h"

namespace rotatebook::farm {

/// The results of a scene that are there.
struct SceneProgress {
  std::vector<bool> units;  ///< Of each, whether it is there.
  bool isWhole = false;     ///< All outputs are there, made of this scene by this program.

  std::int64_t count() const;
  /// Returns whether all units of a part are there.
  bool has(const store::ClipPart& part) const;
};

/// Returns the progress of each scene. What other settings made doesn't count. Throws InputError if
/// a folder can't be read.
std::vector<SceneProgress> progressOf(const Plan& plan, const PlanFiles& files);

/// Returns whether all that a task makes is there.
bool isDone(const Plan& plan, const Task& task, const std::vector<SceneProgress>& progress);

/// Returns whether all clips or maps are there that are joined of parts.
bool areJoined(const Plan& plan, const std::vector<SceneProgress>& progress);

/// Throws InputError if the folder of results holds unfinished work of other scenes or of another
/// build under the same names, which tasks would refuse to go on with.
void requireSameResults(const Plan& plan);

}  // namespace rotatebook::farm
