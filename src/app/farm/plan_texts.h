// Plans for other engines than Slurm, as text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "farm/plan.h"

namespace rotatebook::farm {

/// A format of plans.
struct PlanFormat {
  const char* name;  ///< As --plan has it.
  /// Returns the plan of these tasks, and of what joins the results after them.
  std::string (*text)(const Plan& plan, const std::vector<Task>& tasks);
};

/// Returns the format with that name. Throws InputError, with those that there are.
const PlanFormat& planFormat(std::string_view name);

/// Returns the commands, one a line; that which joins the results is last, after a comment.
std::string listText(const Plan& plan, const std::vector<Task>& tasks);
/// Returns a shell script that has GNU parallel run the commands, on this machine or, by the
/// options that are passed on, on others.
std::string parallelText(const Plan& plan, const std::vector<Task>& tasks);

}  // namespace rotatebook::farm
