#include "scene/motion_events.h"

#include <algorithm>
#include <cstddef>

#include "base/error.h"
#include "base/number_text.h"
#include "base/text.h"
#include "physics/integrators/step_error.h"
#include "recording/recorded_motion.h"
#include "scene/keys/moments.h"
#include "scene/limits.h"

namespace rotatebook::scene {
namespace {

constexpr int kTimeDigits = 4;
constexpr int kBurstParts = 32;  // of the time between samples

[[noreturn]] void refuseEvent(const Moment& moment, const std::string& has) {
  throw InputError(has + ", so there is no \"" + eventText(moment) + "\"");
}

}  // namespace

MotionEvents::MotionEvents(const Panel& motion, double interval, double longest)
    : motion_(motion), interval_(interval), longest_(longest) {
  if (const auto& recorded = motion.simulation.recorded.motion; recorded != nullptr)
    longest_ = std::min(longest_, recorded->duration());
}

double MotionEvents::timeOf(const Moment& moment) {
  if (moment.event == Event::Nudge) return nudge(moment);
  if (!simulation_) {
    simulation_.emplace(motion_.motion(), physics::Compared::No);
    last_ = simulation_->trajectory().samples.front();
  }
  return moment.event == Event::Flip ? flip(moment) : burst();
}

/// Takes the next sample; returns whether there was one.
bool MotionEvents::advance() {
  const double time = static_cast<double>(samples_++) * interval_;
  if (isDone_ || time > longest_) return false;
  const bool isLong = physics::takesSteps(motion_.simulation.model) &&
                      time / motion_.simulation.steps().length() > kMaxStepsToEvent;
  if (isLong || samples_ > kMaxFrames) {
    throw InputError("the event isn't found within " +
                     (isLong ? std::to_string(kMaxStepsToEvent) + " integration steps"
                             : std::to_string(kMaxFrames) + " frames") +
                     "; state a time in seconds");
  }
  std::optional<physics::Sample> next;
  try {
    next = simulation_->sampleOnce(time);
  } catch (const physics::StepError&) {  // It is reported where the motion is shown.
  }
  isDone_ = !next;
  if (isDone_) burst_ = time;
  if (isDone_) return false;
  if (next->halfTurns > last_.halfTurns)
    flips_.resize(static_cast<std::size_t>(next->halfTurns), halfTurnTime(last_, *next));
  last_ = *next;
  return true;
}

std::string MotionEvents::lastingText() const {
  return "within " + roundedText(longest_, kTimeDigits) + " s the motion ";
}

double MotionEvents::flip(const Moment& moment) {
  const auto number = static_cast<std::size_t>(moment.number);
  while (flips_.size() < number && advance()) continue;
  if (flips_.size() >= number) return flips_[number - 1];
  refuseEvent(moment, lastingText() + "flips " + countText(std::ssize(flips_), "time"));
}

double MotionEvents::nudge(const Moment& moment) const {
  const auto number = static_cast<std::size_t>(moment.number);
  if (number <= motion_.nudges.size()) return motion_.nudges[number - 1].at;
  refuseEvent(moment, "the motion has " + countText(std::ssize(motion_.nudges), "nudge"));
}

/// Returns the time of a burst between two samples, to a kBurstParts-th of the time between them.
double MotionEvents::foundFiner(double after, double until) const {
  physics::Simulation again(motion_.motion(), physics::Compared::No);
  try {
    for (int part = 1; part < kBurstParts; ++part) {
      const double time = after + (until - after) * part / kBurstParts;
      if (!again.sampleOnce(time)) return time;
    }
  } catch (const physics::StepError&) {
    // A step that can't be made has no time of its own.
  }
  return until;
}

double MotionEvents::burst() {
  while (advance()) continue;
  if (burst_) return foundFiner(last_.time, *burst_);
  refuseEvent({.event = Event::Burst}, lastingText() + "doesn't diverge");
}

}  // namespace rotatebook::scene
