// The paper's first way: eight particles joined by springs.
#pragma once

#include <array>
#include <cstddef>

#include "physics/cage_fit.h"
#include "physics/motion_settings.h"
#include "physics/simulator.h"
#include "physics/spring_network.h"

namespace rotatebook::physics {

/// Particles of mass m = M/8 at the corners, each pair joined by a spring of stiffness k at its
/// rest length and by a damper along it. With F(x, v) the forces, a step is
///   Euler            x += h v, then v += h F(x, v)/m with the x and v before: the paper's.
///                    Order 1; L grows with h w^2. One evaluation of F.
///   SymplecticEuler  v += h F(x, v)/m, then x += h v. Order 1; keeps L to rounding.
///   Verlet           A half step of v, x += h v, the other half at the new x, with v + h F/m in
///                    the dampers. Order 2; keeps L to rounding. Two evaluations.
///   Rk4              Runge and Kutta's classical method. Order 4. Four evaluations.
/// The undamped network is stable below h = 0.707 sqrt(m/k) (SymplecticEuler and Verlet) or
/// 1.000 (Rk4); with the paper's damping below 0.129 (Euler), 0.121 (SymplecticEuler),
/// 0.125 (Verlet) or 0.180 (Rk4). Sources: Hairer, Lubich, Wanner, Geometric Numerical Integration,
/// chapter I; the limits follow from the network's largest eigenvalue, 8 k/m.
///
/// Damping is given as a fraction of 2 sqrt(k m), which the paper derives for one particle on a
/// fixed wall. A pair has the reduced mass m/2 and would be critical at sqrt(2 k m): the paper's
/// setting 1 overdamps a lone pair by sqrt(2).
///
/// Normalisation undoes the energy error of each step by scaling the velocities to the kinetic
/// energy that is left beside the springs, E - U, and keeps the centre of mass at rest in the
/// origin. L is scaled with the velocities: normalised, no integrator keeps it. E - U is kept at
/// E/10 or more, as the paper's published program does: where nearly all energy has gone into
/// springs its square root would be imaginary. Where this floor bites, that is U > 0.9 E, the
/// energy after a step is U + E/10, more than E.
class ParticleSimulator final : public Simulator {
 public:
  explicit ParticleSimulator(const MotionSettings& settings);

  void advance(double h, int steps) override;
  BodyState state() const override;

 private:
  using Step = void (ParticleSimulator::*)(double h);

  static Step stepOf(Integrator integrator);
  void stepEuler(double h);
  void stepSymplecticEuler(double h);
  void stepVerlet(double h);
  void stepRk4(double h);
  Points accelerations(const Points& velocities) const;
  void moveTo(const Points& positions);
  double kineticEnergy() const;
  void restoreEnergy();
  void restoreCentre();

  Points positions_{};
  Points velocities_{};
  double mass_;  // of one particle
  SpringNetwork springs_;
  Step step_;
  bool normalize_;
  double energy_ = 0;  // at t = 0
  CageFit fit_;
};

}  // namespace rotatebook::physics
