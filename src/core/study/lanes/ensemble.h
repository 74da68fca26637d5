// Many motions at once, in the lanes of the processor's vectors. Inside the room only.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "physics/motion_settings.h"
#include "physics/simulator.h"
#include "study/lanes/instruction_set.h"
#include "study/lanes/outcome.h"

namespace rotatebook::study::lanes {

/// A motion that is watched for half-turns: at its start, after every so many frames, and at its
/// end.
struct WatchedMotion {
  physics::MotionSettings motion{};
  std::int64_t frames = 0;         ///< Its length, >= 0. [EqualSteps::time]
  std::int64_t framesPerLook = 1;  ///< >= 1
};

/// Watches motions, bit by bit as physics::TurnWatch does. Those of Model::Quaternion by euler,
/// rk4, midpoint, dmv2, dmv4 and dmv6, and of Model::Matrix by euler, are made several at a time if
/// they have no nudges, and the same integrator, substeps, normalizeEvery and looks: hand in some
/// hundred of them that have.
class Ensemble {
 public:
  /// If `stop` isn't null and another thread sets it, the rest is left out, and the outcomes must
  /// be discarded.
  explicit Ensemble(InstructionSet set = widestSet(), const std::atomic<bool>* stop = nullptr);
  ~Ensemble();

  /// Takes the next motion, which may change afterwards.
  void add(const WatchedMotion& watched);
  /// Makes the rest. Returns what came of each motion, in their order.
  std::vector<Outcome> finish();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Returns the state of each motion after so many EqualSteps, bit by bit as its simulator
/// reports it; NaN where its step failed. Throws InputError as makeSimulator() does.
std::vector<physics::BodyState> statesAfter(std::span<const physics::MotionSettings> motions,
                                            std::int64_t frames, InstructionSet set = widestSet());

}  // namespace rotatebook::study::lanes
