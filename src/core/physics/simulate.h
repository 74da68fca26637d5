// Simulation of a motion, in slices or as a whole.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "body/cuboid.h"
#include "physics/measure/measurement.h"
#include "physics/motion_settings.h"
#include "physics/simulator.h"
#include "physics/trajectory.h"

namespace rotatebook::physics {

/// Returns whether a motion that has come to this state has diverged: a corner is farther from the
/// origin than kDivergenceFactor times the body's largest dimension, or a number isn't finite.
bool hasBlownUp(const BodyState& state, const body::Cuboid& body);

/// A motion that is simulated sample by sample. The steps are those of samples at even times; a
/// sample between two steps is made from a copy of the simulator that goes on by a shorter step, so
/// that no sample changes the motion.
class Simulation {
 public:
  /// Takes the sample at time 0. Throws InputError as makeSimulator() does, and if the spin is so
  /// large that not even this sample is finite.
  explicit Simulation(const MotionSettings& settings, Compared compared = Compared::WithExact);
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Takes the sample at `time`, not before those so far. [s] Returns false, with no sample, of a
  /// motion that has diverged. Throws StepError if an integrator can't make its steps.
  bool sample(double time);
  /// Takes likewise a sample that isn't kept.
  std::optional<Sample> sampleOnce(double time);
  /// Returns the samples that are kept so far; valid as long as this object.
  const Trajectory& trajectory() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Simulates `sampleCount` >= 1 samples, or fewer if the motion diverges. Throws as Simulation
/// does. If `stop` isn't null and another thread sets
/// it, the simulation ends after a sample, and its result must be discarded.
Trajectory simulate(const MotionSettings& settings, std::int64_t sampleCount,
                    const std::atomic<bool>* stop = nullptr);

/// Simulates likewise one sample for each of `times`, at least one, the first 0 and in their order.
/// [s]
Trajectory simulate(const MotionSettings& settings, std::span<const double> times,
                    const std::atomic<bool>* stop = nullptr);

}  // namespace rotatebook::physics
