// A motion of a block, as scalar code sees it. Inside the room only.
#pragma once

#include <cstddef>
#include <optional>

#include <Eigen/Core>

#include "physics/measure/measurement.h"
#include "physics/motion_settings.h"
#include "physics/steps/rigid_motion.h"
#include "study/lanes/block.h"
#include "study/lanes/outcome.h"

namespace rotatebook::study::lanes {

/// A motion in a lane of a block: fills the lane, and measures what lanes leave to it, bit by bit
/// as simulate() does.
class Member {
 public:
  /// Returns nullopt for motions that lanes don't make, or whose numbers are so large or small that
  /// lanes might not notice where they leave the range of doubles. Throws as
  /// RigidMotion::of().
  static std::optional<Member> of(const physics::MotionSettings& settings);
  /// Returns the motion with other steps, as RigidMotion::withStepsOf() does.
  std::optional<Member> withStepsOf(const physics::MotionSettings& settings) const;

  /// Returns the number of its StepKind.
  std::size_t stepKind() const;

  /// Fills a lane with the state at t = 0.
  void fill(Block& block, int lane) const;
  /// Fills a lane with a body that doesn't turn and needs no care, but keeps its count of
  /// half-turns.
  void fillAtRest(Block& block, int lane) const;
  /// Looks at the motion's start, as lanes look at it later.
  void start(Block& block, int lane) const;
  /// Looks at the frame that the lane is at.
  void attend(Block& block, int lane);
  /// Returns what came of the lane.
  Outcome outcome(const Block& block, int lane) const;
  physics::BodyState state(const Block& block, int lane) const;

 private:
  Member(const physics::MotionSettings& settings, const physics::RigidMotion& motion);

  bool hasOrdinaryNumbers() const;
  void fillBounds(Block& block, int lane) const;
  double timeOf(double frame) const { return frame * interval_; }
  void count(Block& block, int lane, const physics::BodyState& state) const;

  body::Cuboid body_;
  double interval_;  // a frame's [s]
  physics::RigidMotion motion_;
  Eigen::Vector3d spunAxis_;  // in body axes
  bool isFlat_;               // as FlatEulerStep takes it
  Outcome outcome_;
};

}  // namespace rotatebook::study::lanes
