// Analysis of systems of springs: shapes that they hold, and vibrations.
#pragma once

#include "physics/mass_spring_system.h"
#include "physics/motion_settings.h"

namespace rotatebook::physics {

/// Returns whether the springs hold the shape: only the six rigid motions leave all of their
/// lengths as they are, to first order. Factorises the stiffness matrix with three particles held
/// (L D L^T); no pivot may be small.
bool holdShape(const MassSpringSystem& system);

/// Returns the number of pieces that no springs join.
int countPieces(const MassSpringSystem& system);

/// Returns the largest eigenvalue of the stiffness matrix of springs of stiffness 1, by Lanczos'
/// method: 8 for eight particles and all 28 springs. To 1e-8 of it.
double largestEigenvalue(const MassSpringSystem& system);

/// Returns the longest step with which the motion's integrator is stable, 0 if there is none: no
/// vibration about the places at rest grows. [s] Throws InputError as particlesOf() does.
double largestStableStep(const MotionSettings& settings, const MassSpringSystem& system);

}  // namespace rotatebook::physics
