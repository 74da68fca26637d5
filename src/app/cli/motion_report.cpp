#include "cli/motion_report.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "cli/exit_code.h"
#include "cli/expectation_report.h"

namespace rotatebook::cli {
namespace {

constexpr double kHalfTurnDeg = 180;
// The smallest difference that a viewer notices. [degrees]
constexpr double kVisibleDeg = 10;

/// Returns `value` >= 0 rounded up to so many significant digits: "2e-9".
std::string roundedUp(double value, int digits) {
  if (value == 0) return "0";
  const double unit = std::pow(10, std::floor(std::log10(value)) + 1 - digits);
  std::string text = roundedText(std::ceil(value / unit) * unit, digits);
  if (const auto zero = text.find("e-0"); zero != text.npos) text.erase(zero + 2, 1);
  return text;
}

/// Rounds to hundredths of a second, from 100 s on to seconds.
std::string secondsText(double time) {
  const double digits = time < 100 ? 100 : 1;
  return shortestText(std::round(time * digits) / digits);
}

}  // namespace

std::string distanceText(const physics::Trajectory& trajectory, physics::Model model) {
  if (model == physics::Model::Exact) return "the exact motion itself, in closed form";
  const auto& samples = trajectory.samples;
  const double farthest =
      std::ranges::max_element(samples, {}, &physics::Sample::errorDeg)->errorDeg;
  if (farthest < 1) {
    const std::string bound = roundedUp(farthest, 1);
    return "within " + bound + (bound == "1" ? " degree" : " degrees") + " of the exact motion";
  }
  const std::string text =
      "up to " + roundedUp(std::min(farthest, kHalfTurnDeg), 3) + " degrees from the exact motion";
  if (farthest <= kVisibleDeg) return text;
  const auto visible = std::ranges::find_if(
      samples, [](const physics::Sample& sample) { return sample.errorDeg > kVisibleDeg; });
  return text + "; more than " + shortestText(kVisibleDeg) + " from " + secondsText(visible->time) +
         " s on";
}

int reportMotions(const scene::Scene& scene, const timeline::ClipMotion& motion,
                  std::ostream& out) {
  int status = kDone;
  auto trajectory = motion.trajectories().begin();
  for (const scene::Panel& panel : scene::motionsOf(scene)) {
    if (!panel.label.empty()) out << "  " << panel.label << ":\n";
    out << "  " << distanceText(*trajectory, panel.simulation.model) << '\n';
    status = std::max(status, reportMotion(*trajectory++, panel.expectations, out));
  }
  return status;
}

}  // namespace rotatebook::cli
