// The discrete Moser-Veselov integrators of a rigid body. Inside the room only.
#pragma once

#include <array>

#include "physics/attitude.h"
#include "physics/integrators/eigen_numbers.h"
#include "physics/integrators/implicit_step.h"
#include "physics/integrators/rigid_state.h"
#include "physics/steps/moser_veselov_step.h"

namespace rotatebook::physics {

/// Returns the moments of inertia, changed by terms in h^2 and h^4 so that the discrete
/// Moser-Veselov algorithm follows the exact motion to `order` 2, 4 or 6. They are constants of the
/// motion. [kg m^2] Throws StepTooLong where one of them is less than half or more than twice the
/// body's: the series in h is then far from its sum. Source: Hairer and Vilmart, Journal of Physics
/// A 39 (2006), after McLachlan and Zanna 2005.
Eigen::Vector3d preprocessedInertia(const RigidConstants& body, double h, int order);

/// The discrete Moser-Veselov algorithm in its quaternion form: with J the preprocessed inertia and
/// a = (h/2) J^-1 M it solves c1 = (1 + |c|^2) a1 + (J2 - J3)/J1 c2 c3 and cyclic; the attitude
/// turns by (1, c) normalised, and M1 += (4/h) (J2 - J3) c2 c3 / (1 + |c|^2) and cyclic. Order 2, 4
/// or 6 at the same cost; keeps the energy, L and the rotation to rounding; integrable like the
/// motion itself. Throws StepError. Source: as preprocessedInertia().
template <int kOrder>
class MoserVeselov {
 public:
  static constexpr bool kMomentumInBody = true;

  MoserVeselov(const RigidConstants& body, double h) : step_(stepOf(body, h)) {}

  /// Returns the step for numbers, of length h [s]. Throws StepTooLong.
  static MoserVeselovStep<double> stepOf(const RigidConstants& body, double h) {
    const Eigen::Vector3d inertia = preprocessedInertia(body, h, kOrder);
    const Eigen::Vector3d differences(inertia[1] - inertia[2], inertia[2] - inertia[0],
                                      inertia[0] - inertia[1]);
    return {toNumbers(h / 2 * inertia.cwiseInverse()), toNumbers(differences),
            toNumbers(differences.cwiseQuotient(inertia)), h};
  }

  template <typename Attitude>
  void step(RigidState<Attitude>& state) const {
    turnInBody(state.attitude, takeMomentumStep(state, step_, SolvedOrThrown{kName, step_.h}));
  }

 private:
  static constexpr std::array kNames{"dmv2", "dmv4", "dmv6"};
  static constexpr const char* kName = kNames[kOrder / 2 - 1];

  MoserVeselovStep<double> step_;
};

}  // namespace rotatebook::physics
