// The scripts of a plan's jobs, for people to read. Inside the room only.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "farm/plan_file.h"

namespace rotatebook::farm {

/// The user's wishes about jobs, which are passed on to Slurm. Empty ones are the cluster's.
struct JobOptions {
  std::string partition{}, account{}, time{}, constraint{};
  std::vector<std::string> others{};  ///< Whole options of sbatch: "--qos=low".
};

/// The most times that a task is tried again.
inline constexpr int kMaxRestarts = 5;

/// Returns "1-4,7" from ascending numbers.
std::string rangesText(const std::vector<std::int64_t>& numbers);

/// Returns the script of an array job of these tasks, or, if there are none, of the join. Where the
/// cluster has `requeues75`, a task is tried again by its exit status, else by scontrol.
std::string jobScript(const Plan& plan, const PlanFiles& files,
                      const std::vector<std::int64_t>& tasks, const JobOptions& options,
                      bool requeues75);

}  // namespace rotatebook::farm
