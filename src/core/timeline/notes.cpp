#include "timeline/notes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/number_text.h"
#include "physics/exact/exact_rotation.h"
#include "physics/motion_start.h"

namespace rotatebook::timeline {
namespace {

using std::numbers::pi;

constexpr double kLargeTilt = 0.5;  // [rad]
constexpr double kLargeBody = 3;    // [m]
constexpr double kFastTurn = pi;    // between two frames [rad]
constexpr double kFewFramesBetweenFlips = 4;
constexpr int kDigits = 3;

void addTiltNote(const scene::Motion& motion, std::vector<std::string>& notes) {
  if (!motion.initial.tilt) return;
  const double angle = std::fabs(motion.initial.tilt->angle);
  if (angle <= kLargeTilt) return;
  notes.push_back("initial.tilt is " + roundedText(angle * 180 / pi, kDigits) +
                  " degrees, as angles are in radians; 1 degree is 0.01745");
}

void addSizeNote(const scene::Motion& motion, std::vector<std::string>& notes) {
  const double size = motion.body.largestDimension();
  if (size <= kLargeBody) return;
  notes.push_back("the body is " + roundedText(size, kDigits) +
                  " m long, as lengths are in metres; 1 cm is 0.01");
}

void addSpeedNotes(const scene::Motion& motion, std::vector<std::string>& notes) {
  const double interval = motion.simulation.timePerFrame;
  const double turn = initialAngularVelocity(motion).norm() * interval;
  if (turn > kFastTurn) {
    notes.push_back("the body spins by " + roundedText(turn / (2 * pi), kDigits) +
                    " turns from frame to frame, which no eye can follow; choose a shorter "
                    "simulation.time_per_frame");
    return;
  }
  const physics::PrincipalAxes inertia = modelInertia(motion);
  const physics::ExactRotation exact(inertia, motion.initial.alongPrincipal(inertia));
  const double frames = exact.flipInterval() / interval;
  if (frames >= kFewFramesBetweenFlips) return;
  notes.push_back(
      "the body flips every " + roundedText(frames, kDigits) +
      " frames, so that frames, half-turns and expectations miss flips; choose a shorter "
      "simulation.time_per_frame");
}

// Particles tumble by their rounding.
void addSteadyNote(const scene::Motion& motion, std::vector<std::string>& notes) {
  if (motion.simulation.model == physics::Model::Particles) return;
  const physics::PrincipalAxes inertia = modelInertia(motion);
  const DoubleDouble3 spin = motion.initial.alongPrincipal(inertia);
  const auto [smallest, median, largest] = physics::axesByInertia(inertia.moments);
  const auto at = [&spin](int axis) { return spin[static_cast<std::size_t>(axis)].high; };
  if (at(median) == 0 || at(smallest) != 0 || at(largest) != 0) return;
  if (inertia.moments[smallest] == inertia.moments[median] ||
      inertia.moments[median] == inertia.moments[largest]) {
    return;
  }
  notes.emplace_back(
      "the spin is exactly about the middle axis, where nothing starts the tumbling; "
      "add initial.tilt, for example [0.001, \"z\"]");
}

std::string prefixOf(const scene::Panel& panel) {
  return panel.label.empty() ? "" : panel.label + ": ";
}

}  // namespace

std::vector<std::string> notesOn(const scene::Scene& scene) {
  std::vector<std::string> all;
  for (const scene::Panel& panel : scene::motionsOf(scene)) {
    std::vector<std::string> notes;
    addTiltNote(panel, notes);
    addSizeNote(panel, notes);
    addSpeedNotes(panel, notes);
    addSteadyNote(panel, notes);
    for (const std::string& note : notes) all.push_back(prefixOf(panel) + note);
  }
  return all;
}

std::vector<std::string> notesOn(const scene::Scene& scene, const ClipMotion& motion) {
  std::vector<std::string> notes;
  auto trajectory = motion.trajectories().begin();
  for (const scene::Panel& panel : scene::motionsOf(scene)) {
    const std::vector<physics::Sample>& samples = (trajectory++)->samples;
    const physics::Regime start = samples.front().regime;
    const auto changed = std::ranges::find_if(
        samples, [&](const physics::Sample& sample) { return sample.regime != start; });
    if (start == physics::Regime::Separatrix || changed == samples.end()) continue;
    notes.push_back(
        prefixOf(panel) + "the regime changes from " + std::to_string(static_cast<int>(start)) +
        " to " + std::to_string(static_cast<int>(changed->regime)) + " at " +
        roundedText(changed->time, kDigits) + " s, as that of a free rigid body never does");
  }
  return notes;
}

}  // namespace rotatebook::timeline
