#include "physics/recorded_simulator.h"

#include "base/error.h"
#include "base/number_text.h"
#include "base/text.h"
#include "physics/motion_start.h"
#include "recording/recorded_motion.h"
#include "rigid/rotation.h"

namespace rotatebook::physics {

RecordedSimulator::RecordedSimulator(const MotionSettings& settings)
    : motion_(settings.simulation.recorded.motion),
      inertia_(modelInertia(settings)),
      slack_(settings.simulation.timePerFrame) {
  if (motion_) return;
  throw InputError("the model \"recorded\" has no recording: the file " +
                   quotedText(settings.simulation.recorded.file) + " hasn't been read");
}

BodyState RecordedSimulator::state() const {
  const double now = time();
  if (now > motion_->duration() + slack_) {
    throw InputError("the recording ends at " + roundedText(motion_->duration(), 6) +
                     " s, but the motion goes on to " + roundedText(now, 6) +
                     " s; make it shorter");
  }
  const recording::RecordedMoment moment = motion_->at(now);
  const Eigen::Vector3d momentum = inertia_.angularMomentum(moment.angularVelocity);
  BodyState result;
  result.worldFromBody = rigid::unnormalisedMatrix(moment.attitude);
  result.angularVelocity = result.worldFromBody * moment.angularVelocity;
  result.angularMomentum = result.worldFromBody * momentum;
  result.kinetic = moment.angularVelocity.dot(momentum) / 2;
  result.rotational = result.kinetic;
  return result;
}

}  // namespace rotatebook::physics
