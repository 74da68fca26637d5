#include "cli/motion_report.h"

#include <algorithm>

#include "cli/exit_code.h"
#include "cli/expectation_report.h"

namespace rotatebook::cli {

int reportMotions(const scene::Scene& scene, const pipeline::ClipMotion& motion,
                  std::ostream& out) {
  int status = kDone;
  auto trajectory = motion.trajectories().begin();
  for (const scene::Panel& panel : scene::motionsOf(scene)) {
    if (!panel.label.empty()) out << "  " << panel.label << ":\n";
    status = std::max(status, reportMotion(*trajectory++, panel.expectations, out));
  }
  return status;
}

}  // namespace rotatebook::cli
