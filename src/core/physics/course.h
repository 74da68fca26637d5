// The course of a motion, of which states at ascending times can be had. Inside the room only.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "physics/motion_settings.h"
#include "physics/simulator.h"

namespace rotatebook::physics {

class PartsOfFrame;

/// A body's motion, of which the states at ascending times can be had. The simulator itself stops
/// only at the ends of EqualSteps, each run of which is called a frame here.
class Course {
 public:
  /// Throws InputError as makeSimulator() does.
  explicit Course(const MotionSettings& settings);

  /// Returns the state at a time not before those so far. [s] Throws StepError.
  BodyState at(double time);

 private:
  Course(const std::optional<Eigen::Matrix3d>& attitude, const MotionSettings& upright);
  double startOf(std::int64_t frame) const { return static_cast<double>(frame) * steps_.time; }
  void makeFrame();
  void advanceWithin(Simulator& simulator, double time) const;
  PartsOfFrame partsTo(Simulator& simulator, double end) const;

  BodyState unturned(double time);

  std::optional<Eigen::Matrix3d> attitude_;  // world from body at t = 0
  std::vector<Nudge> nudges_;                // those of withoutAttitude()
  EqualSteps steps_;
  std::unique_ptr<Simulator> simulator_;
  std::int64_t frame_ = 0;  // the frame at whose start the simulator is
};

}  // namespace rotatebook::physics
