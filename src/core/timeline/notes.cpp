#include "timeline/notes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/number_text.h"
#include "physics/motion_start.h"
#include "recording/recorded_motion.h"
#include "rigid/inertia.h"
#include "rigid/regime.h"
#include "scene/mesh_notes.h"
#include "timeline/free_pieces.h"
#include "timeline/spin.h"

namespace rotatebook::timeline {
namespace {

using std::numbers::pi;

constexpr double kLargeTilt = 0.5;  // [rad]
constexpr double kLargeBody = 3;    // [m]
constexpr double kFewFramesBetweenFlips = 4;
constexpr int kDigits = 3;

void addTiltNote(const scene::Motion& motion, std::vector<std::string>& notes) {
  if (!motion.initial.tilt) return;
  const double angle = std::fabs(motion.initial.tilt->angle);
  if (angle <= kLargeTilt) return;
  notes.push_back("initial.tilt is " + roundedText(angle * 180 / pi, kDigits) +
                  " degrees; numbers without a unit are in radians: one degree is \"1 deg\"");
}

void addSizeNote(const scene::Motion& motion, std::vector<std::string>& notes) {
  const double size = motion.body.largestDimension();
  if (size <= kLargeBody || motion.solid.isShape) return;
  notes.push_back("the body is " + roundedText(size, kDigits) +
                  " m long; numbers without a unit are in metres: a centimetre is \"1 cm\"");
}

std::string remedyForSpeed(const physics::SimulationSettings& settings) {
  return settings.substepped ? "choose a lower clip.speed, such as 0.1"
                             : "choose a shorter simulation.time_per_frame";
}

void addSpeedNote(const scene::Motion& motion, std::vector<std::string>& notes) {
  const double interval = motion.simulation.timePerFrame;
  const double turn = initialAngularVelocity(motion).norm() * interval;
  if (turn > pi) {
    notes.push_back("the body spins by " + roundedText(turn / (2 * pi), kDigits) +
                    " turns from frame to frame, which no eye can follow; " +
                    remedyForSpeed(motion.simulation));
    return;
  }
  const std::optional<double> flips = spinOf(motion).flipInterval();
  if (!flips || *flips / interval >= kFewFramesBetweenFlips) return;
  notes.push_back("the body flips every " + roundedText(*flips / interval, kDigits) +
                  " frames, so that frames, counts and expectations miss some; " +
                  remedyForSpeed(motion.simulation));
}

/// Returns "x" or "z": an axis of the body that `spin` isn't near.
std::string axisAcross(const Eigen::Vector3d& spin) {
  Eigen::Index nearest = 0;
  spin.cwiseAbs().maxCoeff(&nearest);
  return nearest == 0 ? "\"z\"" : "\"x\"";
}

void addSteadyNote(const scene::Panel& panel, const rigid::PrincipalAxes& inertia,
                   const DoubleDouble3& spin, std::vector<std::string>& notes) {
  const Eigen::Vector3d moments = rigid::withEqualMoments(inertia).moments;
  const auto [smallest, middle, largest] = rigid::axesByInertia(moments);
  if (moments[smallest] == moments[middle] || moments[middle] == moments[largest]) {
    return;  // It tumbles about no axis.
  }
  const auto turns = [&spin](int axis) { return spin[static_cast<std::size_t>(axis)].high != 0; };
  if (turns(smallest) + turns(middle) + turns(largest) != 1) return;
  const std::string across = axisAcross(panel.initial.tilted());
  if (turns(middle)) {
    notes.push_back(
        "the spin is exactly about the middle axis, where nothing starts the tumbling; "
        "add initial.tilt, for example [0.001, " +
        across + "]");
    return;
  }
  if (!panel.label.empty()) return;  // In a comparison, steady turning is one of the cases.
  notes.push_back("the spin is exactly about the axis of the " +
                  std::string(turns(largest) ? "largest" : "smallest") +
                  " moment of inertia, so the body turns steadily and shows nothing else; add "
                  "initial.tilt, for example [\"1 deg\", " +
                  across + "], to see that it only wobbles");
}

void addCueNotes(const scene::Scene& scene, std::vector<std::string>& notes) {
  const std::int64_t frames = scene.clip.frameCount();
  const double period = scene.clip.frameRate.period();
  for (const scene::ShownCue& shown : scene.shownCues) {
    const std::string cue = "cue." + std::to_string(shown.cue);
    const auto& move = scene.cues[shown.cue].move;
    const double rest = static_cast<double>(frames - shown.frame) * period;
    if (shown.frame >= frames) {
      notes.push_back(cue + " is at " + roundedText(shown.time, kDigits) +
                      " s of the motion, after the end of the clip, which never shows it");
    } else if (move && move->over > rest + period) {
      notes.push_back(cue + ".move takes " + roundedText(move->over, kDigits) +
                      " s, and the clip ends before, after " + roundedText(rest, kDigits) +
                      " s of it");
    }
  }
}

}  // namespace

std::vector<std::string> notesOn(const scene::Panel& panel) {
  std::vector<std::string> notes = scene::meshNotes(panel.solid);
  addTiltNote(panel, notes);
  addSizeNote(panel, notes);
  const rigid::PrincipalAxes inertia = modelInertia(panel);
  const DoubleDouble3 spin = panel.initial.alongPrincipal(inertia);
  addSpeedNote(panel, notes);
  // Particles tumble by their rounding, and a nudge starts what the spin doesn't.
  if (panel.simulation.model != physics::Model::Particles && panel.nudges.empty()) {
    addSteadyNote(panel, inertia, spin, notes);
  }
  if (const auto& recorded = panel.simulation.recorded.motion; recorded != nullptr)
    notes.insert(notes.end(), recorded->notes().begin(), recorded->notes().end());
  return notes;
}

std::vector<std::string> notesOn(const scene::Scene& scene) {
  std::vector<std::string> all;
  for (const scene::Panel& panel : scene.motions) {
    const std::string prefix = panel.label.empty() ? "" : panel.label + ": ";
    for (const std::string& note : notesOn(panel)) all.push_back(prefix + note);
    const double end = timeAt(scene, static_cast<double>(scene.clip.frameCount() - 1));
    for (const physics::Nudge& nudge : panel.nudges) {
      if (nudge.at <= end) continue;
      all.push_back(prefix + "the nudge at " + roundedText(nudge.at, kDigits) +
                    " s comes after the end of the motion, which lasts " +
                    roundedText(end, kDigits) + " s");
    }
  }
  addCueNotes(scene, all);
  if (scene.clip.poster && *scene.clip.poster > scene.clip.duration) {
    all.push_back("clip.poster is at " + roundedText(*scene.clip.poster, kDigits) +
                  " s, after the end of the clip, which lasts " +
                  roundedText(scene.clip.duration, kDigits) + " s; its last frame is the poster");
  }
  return all;
}

std::string regimeNote(const physics::Trajectory& trajectory,
                       std::span<const physics::Nudge> nudges) {
  for (const std::span<const physics::Sample> piece : freePieces(trajectory, nudges)) {
    const rigid::Regime start = piece.front().regime;
    const auto changed = std::ranges::find_if(
        piece, [&](const physics::Sample& sample) { return sample.regime != start; });
    if (start == rigid::Regime::Separatrix || changed == piece.end()) continue;
    return "the regime changes from " + std::to_string(static_cast<int>(start)) + " to " +
           std::to_string(static_cast<int>(changed->regime)) + " at " +
           roundedText(changed->time, kDigits) + " s, as that of a free rigid body never does";
  }
  return "";
}

}  // namespace rotatebook::timeline
