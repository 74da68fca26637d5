#include "report/motion_report.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "report/expectation_report.h"
#include "timeline/notes.h"

namespace rotatebook::report {
namespace {

constexpr double kHalfTurnDeg = 180;
// The smallest difference that a viewer notices. [degrees]
constexpr double kVisibleDeg = 10;
constexpr double kVisibleChange = 1e-3;  // of the energy

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

std::string halfTurnsText(const physics::Trajectory& trajectory) {
  const int made = trajectory.samples.back().halfTurns;
  return std::to_string(made) + (made == 1 ? " half-turn" : " half-turns");
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

std::string energyText(const physics::Trajectory& trajectory) {
  const double start = trajectory.samples.front().total();
  double lowest = 1, highest = 1;
  for (const physics::Sample& sample : trajectory.samples) {
    lowest = std::min(lowest, sample.total() / start);
    highest = std::max(highest, sample.total() / start);
  }
  const double change = std::max(1 - lowest, highest - 1);
  if (change < kVisibleChange) return "energy kept to " + roundedUp(change, 1);
  return "energy " + roundedText(lowest, 4) + " to " + roundedText(highest, 4) + " of its start";
}

void reportNotes(const scene::Scene& scene, std::ostream& out) {
  for (const std::string& note : timeline::notesOn(scene)) {
    out << "note: " + scene.name + ": " + note + '\n';
  }
}

bool reportMotions(const scene::Scene& scene, const timeline::ClipMotion& motion,
                   std::ostream& out) {
  bool met = true;
  auto trajectory = motion.trajectories().begin();
  for (const scene::Panel& panel : scene::motionsOf(scene)) {
    if (!panel.label.empty()) out << "  " << panel.label << ":\n";
    out << "  " << halfTurnsText(*trajectory) << "; " << energyText(*trajectory) << "; "
        << distanceText(*trajectory, panel.simulation.model) << '\n';
    met &= reportMotion(*trajectory++, panel.expectations, out);
  }
  for (const std::string& note : timeline::notesOn(scene, motion)) {
    out << "  note: " << note << '\n';
  }
  return met;
}

}  // namespace rotatebook::report
