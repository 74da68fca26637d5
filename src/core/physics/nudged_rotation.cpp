#include "physics/nudged_rotation.h"

#include <algorithm>

namespace rotatebook::physics {

NudgedRotation::NudgedRotation(const Start& start, std::span<const Nudge> nudges)
    : inertia_(start.inertia), turn_(start.worldFromBody) {
  pieces_.push_back({0, Eigen::Matrix3d::Identity(),
                     rigid::ExactRotation(start.inertia, start.alongPrincipal), start.momentum});
  for (const Nudge& nudge : nudges) add(nudge);
}

NudgedRotation::Moment NudgedRotation::at(double time) const {
  const Moment moment = unturned(time);
  if (!turn_) return moment;
  return {*turn_ * moment.worldFromBody, *turn_ * moment.angularVelocity,
          *turn_ * moment.angularMomentum, moment.regime};
}

NudgedRotation::Moment NudgedRotation::unturned(double time) const {
  const std::size_t index = pieceAt(time);
  const Piece& piece = pieces_[index];
  const rigid::ExactRotation::Moment moment = piece.rotation.at(time - piece.start);
  const rigid::Regime regime = piece.rotation.regime();
  if (index == 0) {
    return {moment.worldFromBody, moment.angularVelocity, piece.momentum, regime};
  }
  return {piece.worldFromBody * moment.worldFromBody, piece.worldFromBody * moment.angularVelocity,
          piece.momentum, regime};
}

Eigen::Vector3d NudgedRotation::angularVelocityBodyAt(double time) const {
  const Piece& piece = pieces_[pieceAt(time)];
  return piece.rotation.angularVelocityBodyAt(time - piece.start);
}

std::size_t NudgedRotation::pieceAt(double time) const {
  const auto next = std::find_if(pieces_.begin() + 1, pieces_.end(),
                                 [&](const Piece& piece) { return piece.start > time; });
  return static_cast<std::size_t>(next - pieces_.begin()) - 1;
}

void NudgedRotation::add(const Nudge& nudge) {
  const Moment before = unturned(nudge.at);
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
