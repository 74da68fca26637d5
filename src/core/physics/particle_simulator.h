// The paper's first model: particles joined by springs. Inside the room only.
#pragma once

#include <memory>

#include "physics/cadence.h"
#include "physics/cage_fit.h"
#include "physics/integrators/particle_state.h"
#include "physics/motion_settings.h"
#include "physics/particle_fit.h"
#include "physics/simulator.h"

namespace rotatebook::physics {

/// Simulates particles of equal mass m joined by springs of stiffness k, at rest length at t = 0,
/// and by dampers along them: by SpringNetwork those at the eight corners, and others of which
/// eight are joined by all 28 springs; by ManySprings any others. The step limits of the
/// integrators follow from the network's largest eigenvalue, for eight and 28 springs 8 k/m.
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
template <typename Springs>
class BasicParticleSimulator final : public Simulator {
 public:
  /// Uses `step`, whatever integrator the settings name. Throws InputError as particlesOf() does.
  BasicParticleSimulator(const MotionSettings& settings, BasicParticleStep<Springs> step);

  void advance(double interval, int steps) override;
  void advancePart(double part) override { step_(state_, part); }
  /// The energy that normalising restores changes by that of the nudge.
  void nudge(const Nudge& nudge) override;
  std::unique_ptr<Simulator> copy() const override {
    return std::make_unique<BasicParticleSimulator>(*this);
  }
  BodyState state() const override;

 private:
  void restoreEnergy();
  template <typename Positions>
  Eigen::Matrix3d worldFromBody(const Positions& positions) const;

  BasicParticleState<Springs> state_;
  BasicParticleStep<Springs> step_;
  Cadence energyNormalization_, driftRemoval_;
  double energy_;  // at t = 0, and what nudges have added
  CageFit fit_;
  std::shared_ptr<const ParticleFit> placedFit_;  // null for the corners, which are the cage
};

using ParticleSimulator = BasicParticleSimulator<SpringNetwork>;
using ManyParticleSimulator = BasicParticleSimulator<ManySprings>;

extern template class BasicParticleSimulator<SpringNetwork>;
extern template class BasicParticleSimulator<ManySprings>;

}  // namespace rotatebook::physics
