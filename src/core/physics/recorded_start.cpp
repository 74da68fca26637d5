#include "physics/recorded_start.h"

#include <utility>

#include "base/error.h"
#include "recording/recorded_motion.h"

namespace rotatebook::physics {

void takeRecording(MotionSettings& settings,
                   std::shared_ptr<const recording::RecordedMotion> recording,
                   const std::string& name) {
  const Eigen::Vector3d spin = recording->moments().front().angularVelocity;
  if (spin.isZero(0)) {
    const recording::RecordedMotion* sound = recording->sound();
    const bool isHeld = sound != nullptr && !sound->moments().front().angularVelocity.isZero(0);
    throw InputError(name + (isHeld ? ": the body moves, but the first rows repeat one attitude; "
                                      "leave out rows that repeat the one before, or state where "
                                      "these end in simulation.from, or with --from"
                                    : ": the body is at rest at first; say when its motion starts "
                                      "with simulation.from, or --from"));
  }
  settings.simulation.model = Model::Recorded;
  settings.simulation.recorded.motion = std::move(recording);
  settings.initial = {SpinKind::AngularVelocity, spin};
}

}  // namespace rotatebook::physics
