#include "physics/turn_watch.h"

#include "base/error.h"
#include "physics/course.h"
#include "physics/measure/measurement.h"
#include "physics/motion_start.h"
#include "physics/simulate.h"
#include "rigid/rotation.h"

namespace rotatebook::physics {

struct TurnWatch::Parts {
  explicit Parts(const MotionSettings& settings)
      : body(settings.body),
        spunAxis(spunAxisOf(settings, modelInertia(settings))),
        course(settings) {}

  body::Cuboid body;
  Eigen::Vector3d spunAxis;
  Course course;
  HalfTurnCounter counter;
  int halfTurns = 0;
  std::optional<double> divergedAt{};
};

TurnWatch::TurnWatch(const MotionSettings& settings) : parts_(std::make_unique<Parts>(settings)) {
  if (!look(0)) throw InputError("the motion's start is not finite: its numbers are too large");
}

TurnWatch::~TurnWatch() = default;

bool TurnWatch::look(double time) {
  if (parts_->divergedAt) return false;
  const BodyState state = parts_->course.at(time);
  if (hasBlownUp(state, parts_->body)) {
    parts_->divergedAt = time;
    return false;
  }
  const rigid::Polar polar = rigid::polarDecomposition(state.worldFromBody);
  if (!keepsItsShape(polar.singularValues[2], polar.singularValues[0])) parts_->counter.stop();
  const Eigen::Vector3d axis = polar.rotation * parts_->spunAxis;
  parts_->halfTurns =
      parts_->counter.countCosine(axis.dot(state.angularMomentum), state.angularMomentum.norm());
  return true;
}

int TurnWatch::halfTurns() const {
  return parts_->halfTurns;
}

std::optional<double> TurnWatch::divergedAt() const {
  return parts_->divergedAt;
}

}  // namespace rotatebook::physics
