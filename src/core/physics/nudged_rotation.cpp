#include "physics/nudged_rotation.h"

#include <algorithm>

namespace rotatebook::physics {

NudgedRotation::NudgedRotation(const Start& start, std::span<const Nudge> nudges)
    : inertia_(start.inertia) {
  pieces_.push_back({0, Eigen::Matrix3d::Identity(),
                     rigid::ExactRotation(start.inertia, start.alongPrincipal), start.momentum});
  for (const Nudge& nudge : nudges) add(nudge);
}

NudgedRotation::Moment NudgedRotation::at(double time) const {
  // Find the last piece that has started; the first one holds before t = 0, too
  const auto next = std::find_if(pieces_.begin() + 1, pieces_.end(),
                                 [&](const Piece& piece) { return piece.start > time; });
  const Piece& piece = *(next - 1);

  const rigid::ExactRotation::Moment moment = piece.rotation.at(time - piece.start);
  const rigid::Regime regime = piece.rotation.regime();
  if (next == pieces_.begin() + 1) {
    return {moment.worldFromBody, moment.angularVelocity, piece.momentum, regime};
  }
  return {piece.worldFromBody * moment.worldFromBody, piece.worldFromBody * moment.angularVelocity,
          piece.momentum, regime};
}

void NudgedRotation::add(const Nudge& nudge) {
  const Moment before = at(nudge.at);
  const Eigen::Matrix3d& worldFromBody = before.worldFromBody;
  Eigen::Vector3d change = nudge.value;
  if (nudge.kind == SpinKind::AngularVelocity) {
    const bool isInBody = nudge.axes == Nudge::Axes::Body;
    change = inertia_.angularMomentum(isInBody ? change : worldFromBody.transpose() * change);
    change = worldFromBody * change;
  } else if (nudge.axes == Nudge::Axes::Body) {
    change = worldFromBody * change;
  }
  const Eigen::Vector3d momentum = before.angularMomentum + change;
  const Eigen::Vector3d velocity = inertia_.angularVelocity(worldFromBody.transpose() * momentum);
  pieces_.push_back({nudge.at, worldFromBody, rigid::ExactRotation(inertia_, velocity), momentum});
}

}  // namespace rotatebook::physics
