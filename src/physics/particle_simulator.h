// The paper's first way: eight particles joined by springs.
#pragma once

#include <array>

#include "physics/motion_settings.h"
#include "physics/simulator.h"

namespace rotatebook::physics {

/// Particles of mass m = M/8 at the corners, each pair joined by a spring of stiffness k at its
/// rest length and by a damper along it. One step is explicit Euler: positions move by the
/// velocities before the step, then the velocities change.
///
/// Damping is given as a fraction of 2 sqrt(k m), which the paper derives for one particle on a
/// fixed wall. A pair has the reduced mass m/2 and would be critical at sqrt(2 k m): the paper's
/// setting 1 overdamps a lone pair by sqrt(2).
///
/// Normalisation undoes the energy error of each step by scaling the velocities to the kinetic
/// energy that is left beside the springs, E - U, and keeps the centre of mass at rest in the
/// origin. E - U is kept at E/10 or more, as the paper's published program does: where nearly all
/// energy has gone into springs its square root would be imaginary. Where this floor bites, that is
/// U > 0.9 E, the energy after a step is U + E/10, more than E.
class ParticleSimulator final : public Simulator {
 public:
  explicit ParticleSimulator(const MotionSettings& settings);

  void advance(double h) override;
  BodyState state() const override;

 private:
  // Plain arrays in place of Eigen's, because this loop is all that the particles' speed hangs on,
  // in debug builds too.
  using Points = std::array<std::array<double, 3>, 8>;

  Points forces() const;
  double kineticEnergy() const;
  double potentialEnergy() const;
  void restoreEnergy();
  void restoreCentre();

  Points positions_{};
  Points velocities_{};
  std::array<double, 28> restLengths_{};
  double mass_;       // of one particle
  double stiffness_;  // of each spring
  double damping_;    // of each damper [kg/s]
  double energy_;     // at t = 0
  bool normalize_;
};

}  // namespace rotatebook::physics
