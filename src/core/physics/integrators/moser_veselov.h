// The discrete Moser-Veselov integrators of a rigid body. Inside the room only.
#pragma once

#include <array>

#include "physics/attitude.h"
#include "physics/integrators/implicit_step.h"
#include "physics/integrators/rigid_state.h"

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

  MoserVeselov(const RigidConstants& body, double h)
      : inertia_(preprocessedInertia(body, h, kOrder)),
        half_(h / 2 * inertia_.cwiseInverse()),
        differences_(inertia_[1] - inertia_[2], inertia_[2] - inertia_[0],
                     inertia_[0] - inertia_[1]),
        ratios_(differences_.cwiseQuotient(inertia_)),
        h_(h) {}

  template <typename Attitude>
  void step(RigidState<Attitude>& state) const {
    const Eigen::Vector3d a = half_.cwiseProduct(state.momentum);
    const Eigen::Vector3d c = solveStep(a, Equation{a, ratios_}, kName, h_);
    turnInBody(state.attitude, Eigen::Quaterniond(1, c.x(), c.y(), c.z()).normalized());
    addCompensated(4 / (h_ * (1 + c.squaredNorm())) * differences_.cwiseProduct(products(c)),
                   state.momentum, state.momentumCarry);
  }

 private:
  /// The equations of c, with share a for a.
  struct Equation {
    const Eigen::Vector3d& a;
    const Eigen::Vector3d& ratios;

    Eigen::Vector3d solutionAtZero() const { return {0, 0, 0}; }
    Eigen::Vector3d next(const Eigen::Vector3d& c, double share) const {
      return (1 + c.squaredNorm()) * share * a + ratios.cwiseProduct(products(c));
    }
    Eigen::Matrix3d derivative(const Eigen::Vector3d& c, double share) const {
      Eigen::Matrix3d ofProducts;
      ofProducts << 0, c.z(), c.y(), c.z(), 0, c.x(), c.y(), c.x(), 0;
      return 2 * share * a * c.transpose() + ratios.asDiagonal() * ofProducts;
    }
  };

  static constexpr std::array kNames{"dmv2", "dmv4", "dmv6"};
  static constexpr const char* kName = kNames[kOrder / 2 - 1];

  static Eigen::Vector3d products(const Eigen::Vector3d& c) {
    return {c.y() * c.z(), c.z() * c.x(), c.x() * c.y()};
  }

  Eigen::Vector3d inertia_;
  Eigen::Vector3d half_;         // (h/2) J^-1
  Eigen::Vector3d differences_;  // J2 - J3 and cyclic
  Eigen::Vector3d ratios_;       // (J2 - J3)/J1 and cyclic
  double h_;
};

}  // namespace rotatebook::physics
