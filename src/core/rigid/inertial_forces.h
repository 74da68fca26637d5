// The forces that act on a part of a rigid body, as an observer describes them who turns.
#pragma once

#include <Eigen/Core>

#include "rigid/inertia.h"

namespace rotatebook::rigid {

/// The rotation of a rigid body, or of a frame of reference, about the origin at one moment, along
/// its own axes.
struct Turning {
  Eigen::Vector3d rate{0, 0, 0};          ///< [rad/s]
  Eigen::Vector3d acceleration{0, 0, 0};  ///< 0 if it is steady. [rad/s^2]
};

/// Returns the rotation without torque of a body with this inertia, whose angular momentum L is I
/// w: its acceleration is I^-1 (L x w), Euler's equation. With a sink of energy of this rate eps it
/// turns at O = w + eps I^-1 a instead, a = I^-1 (L x w), and L' = L x O. All along the body's
/// axes. [rad/s], [kg m^2 s]
Turning freeTurning(const PrincipalAxes& inertia, const Eigen::Vector3d& w, double dissipation = 0);

/// The forces on a mass in a frame that turns, for each kilogram of it, along the frame's axes.
/// Their sum is the mass's acceleration in the frame. [N/kg]
struct ForcesPerMass {
  Eigen::Vector3d centrifugal{0, 0, 0};  ///< -O x (O x X)
  Eigen::Vector3d coriolis{0, 0, 0};     ///< -2 O x V
  Eigen::Vector3d euler{0, 0, 0};        ///< -dO/dt x X
  Eigen::Vector3d held{0, 0, 0};         ///< By the rest of the body.

  Eigen::Vector3d sum() const { return centrifugal + coriolis + euler + held; }
};

/// Returns the forces on a mass at `place` of a body without torque that turns about its centre of
/// mass. [m], body axes; `frameFromBody` is the body's attitude in the frame. Source: Landau and
/// Lifshitz, Mechanics, section 39.
ForcesPerMass forcesIn(const Turning& frame, const Eigen::Matrix3d& frameFromBody,
                       const Turning& body, const Eigen::Vector3d& place);

}  // namespace rotatebook::rigid
