// The paper's first model: eight particles joined by springs. Inside the room only.
#pragma once

#include <memory>

#include "physics/cadence.h"
#include "physics/cage_fit.h"
#include "physics/integrators/particle_state.h"
#include "physics/motion_settings.h"
#include "physics/simulator.h"

namespace rotatebook::physics {

/// Simulates particles of mass m = M/8 at the corners, each pair joined by a spring of stiffness k,
/// at its rest length at t = 0, and by a damper along it. The step limits of the integrators follow
/// from the network's largest eigenvalue, 8 k/m.
///
/// Damping is given as a fraction of 2 sqrt(k m), which the paper derives for one particle on a
/// fixed wall. A pair has the reduced mass m/2 and is critically damped at sqrt(2 k m): the paper's
/// setting 1 overdamps a lone pair by sqrt(2).
///
/// Normalising the energy undoes the error of the steps since the last time: it scales the
/// velocities to the kinetic energy that the springs leave, E - U. It scales L with the velocities:
/// normalised, no integrator keeps it. E - U is kept at E/10 or more,
/// as in the paper's published program: where nearly all energy has gone into springs, its square
/// root would be imaginary. Where this floor applies, that is U > 0.9 E, the energy is then U +
/// E/10, more than E. Removing the drift brings the centre of mass to rest at the origin.
class ParticleSimulator final : public Simulator {
 public:
  /// Uses `step`, whatever integrator the settings name.
  ParticleSimulator(const MotionSettings& settings, ParticleStep step);

  void advance(double interval, int steps) override;
  void advancePart(double part) override { step_(state_, part); }
  /// The energy that normalising restores changes by that of the nudge.
  void nudge(const Nudge& nudge) override;
  std::unique_ptr<Simulator> copy() const override {
    return std::make_unique<ParticleSimulator>(*this);
  }
  BodyState state() const override;

 private:
  void restoreEnergy();

  ParticleState state_;
  ParticleStep step_;
  Cadence energyNormalization_, driftRemoval_;
  double energy_;  // at t = 0, and what nudges have added
  CageFit fit_;
};

}  // namespace rotatebook::physics
