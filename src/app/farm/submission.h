// Submission of a plan to Slurm.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "farm/job_script.h"
#include "farm/plan_file.h"
#include "farm/slurm.h"

namespace rotatebook::farm {

/// The outcome of submit().
struct Submission {
  std::vector<std::int64_t> sent{};  ///< Numbers of the tasks.
  std::int64_t tasks = 0;            ///< All of the plan.
  std::int64_t done = 0;             ///< Of these, those that were done before.
  std::int64_t queued = 0;           ///< Tasks that an earlier submission has in the queue.
  std::string array{}, join{};       ///< The new jobs; empty if there was nothing to send.
  bool isWhole = false;              ///< All results are there.
};

/// Returns the plan on the disk, with its parts and jobs, if that does the same as `plan`; nothing
/// if `plan` is to take its place. Throws InputError if another plan still has jobs in the queue of
/// this cluster, or if the folder of results holds unfinished work of other settings. Changes
/// nothing.
std::optional<StoredPlan> continued(const Plan& plan, const PlanFiles& files);
/// Throws InputError if jobs of the plan on the disk are still in the queue, which `plan` would
/// divide otherwise.
void requireNoneQueued(const StoredPlan& earlier, const Plan& plan);

/// Returns the tasks whose results are missing.
std::vector<Task> missingTasks(const Plan& plan, const PlanFiles& files);

/// Returns whether all that a plan's tasks and its join make is there.
bool isMade(const Plan& plan, const PlanFiles& files);

/// Sends what is missing of a plan, that of continued(): an array job, and one that joins the
/// results once all are there. Throws as slurm.h says; then, nothing of it is left in the queue, or
/// the message names what is.
Submission submit(StoredPlan stored, const PlanFiles& files, const JobOptions& options,
                  const ClusterLimits& limits);

}  // namespace rotatebook::farm
