// The state of plans that were submitted.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "farm/plan_file.h"

namespace rotatebook::farm {

/// The state of a task, or of the join.
struct TaskState {
  enum class Kind { Done, Running, Waiting, Failed };

  std::string name;  ///< "part 3/16 of NAME", "join"
  Kind kind = Kind::Waiting;
  std::string node{};           ///< The one where it runs, or failed.
  std::int64_t seconds = 0;     ///< Since it began, while it runs.
  std::string reason{};         ///< Why it waits or failed.
  std::filesystem::path log{};  ///< Of one that runs or failed.
};

/// Returns "done", "running", "waiting" or "failed".
const char* nameOf(TaskState::Kind kind);

/// The state of a scene's results.
struct SceneState {
  std::string name;
  std::int64_t done = 0, units = 0;  ///< Frames or tiles.
  bool isWhole = false;              ///< All files are there.
};

/// The state of a plan.
struct PlanState {
  Plan plan;
  Jobs jobs;
  std::vector<SceneState> scenes{};
  std::vector<TaskState> tasks{};     ///< Without the join.
  std::optional<TaskState> join{};    ///< Of plans that have one.
  std::optional<double> remaining{};  ///< Until the tasks have ended, as they run now. [s]
  std::string queueProblem{};  ///< Why the queue isn't known; empty if it is, or isn't needed.

  std::int64_t count(TaskState::Kind kind) const;
  bool isWhole() const;
  bool hasFailed() const;
};

/// Returns the state of each plan below `results`: of renders, maps and studies. Throws InputError
/// if there is none.
std::vector<PlanState> statesBelow(const std::filesystem::path& results);

/// Returns the state of a plan, from its files and what the cluster knows.
PlanState stateOf(const StoredPlan& stored, const PlanFiles& files);

}  // namespace rotatebook::farm
