// The folder of a plan, DIR/farm/COMMAND/: what is written and removed there.
#pragma once

#include "farm/plan_file.h"
#include "store/footprint.h"

namespace rotatebook::farm {

/// Adds to `footprint` what submit writes and removes in a plan's folder.
void addPlanTo(store::Footprint& footprint, const PlanFiles& files);

/// Writes a new plan and its tasks in the place of an earlier one, and removes what the earlier
/// one's tasks printed, and how they ended. Throws InputError, before anything is changed, if a
/// file that no plan is known to have left would be written over, or one removed through a link.
void writeNewPlan(const PlanFiles& files, const StoredPlan& stored);

/// Writes the plan if another or none is there, as writeNewPlan() does; else only those of its
/// tasks' files that are lost or were changed.
void storePlan(const PlanFiles& files, const StoredPlan& stored);

}  // namespace rotatebook::farm
