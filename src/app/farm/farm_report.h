// Reports of plans for many machines.
#pragma once

#include <ostream>
#include <vector>

#include "farm/plan.h"
#include "farm/status.h"
#include "farm/submission.h"

namespace rotatebook::farm {

/// Prints what was sent, what was left out because it is there or on its way, and what to do next.
void reportSubmission(const Plan& plan, const Submission& submission, std::ostream& out);

/// Prints plans for people: what is done, who does what, what failed and when it ends.
void reportStates(const std::vector<PlanState>& states, std::ostream& out);
/// Prints them as one JSON object.
void reportStatesAsJson(const std::vector<PlanState>& states, std::ostream& out);

}  // namespace rotatebook::farm
