// The particles of a motion: their places, and the springs between them.
#pragma once

#include "physics/mass_spring_system.h"
#include "physics/motion_settings.h"

namespace rotatebook::physics {

/// Returns eight places (+-p, +-q, +-r) along the principal axes of `inertia` [kg m^2], p^2 = (I_y
/// + I_z - I_x)/(2 M) and cyclic: eight particles of M/8 there have that inertia. In the order of a
/// cage's corners. [m] Source: Routh, Dynamics of a System of Rigid Bodies, on equimomental
/// systems.
std::vector<Eigen::Vector3d> equimomentalPlaces(const rigid::PrincipalAxes& inertia, double mass);

/// Returns the particles of the motion. Throws InputError if they follow from a surface, and
/// nobody has placed them.
MassSpringSystem particlesOf(const MotionSettings& settings);

}  // namespace rotatebook::physics
