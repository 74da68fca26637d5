// The regime of a free rigid body: the axis that its angular momentum circles.
#pragma once

#include <array>

#include <Eigen/Core>

#include "base/double_double.h"

namespace rotatebook::rigid {

/// The axis that the angular momentum circles in the body frame: of the smallest or of the largest
/// moment of inertia. The separatrix between them contains the spin about the middle axis.
enum class Regime { AboutSmallest = -1, Separatrix = 0, AboutLargest = 1 };

/// Returns the axes in the order of their moments, smallest first.
std::array<int, 3> axesByInertia(const Eigen::Vector3d& inertia);
std::array<int, 3> axesByInertia(const DoubleDouble3& inertia);

/// Returns sqrt(|N2|) with the sign of N2 = I3 (I3 - I2) w3^2 - I1 (I2 - I1) w1^2, which is L^2 - 2
/// T I2 without its cancellation. N2 is summed without error, then rounded to 106 bits, so that its
/// sign is exact however close to the separatrix. `moments` are I1 <= I2 <= I3, each > 0, in a
/// ratio of up to 1e15. [kg m^2 / s]
DoubleDouble middleInvariantRoot(const DoubleDouble3& moments, DoubleDouble w1, DoubleDouble w3);

/// Returns the regime of a body with these principal moments, in any order, each > 0, in a ratio of
/// up to 1e15. [kg m^2] The numbers are taken as they are: a spin whose decimals lie on the
/// separatrix is beside it once they are rounded to doubles. The regime of a body at rest, of a
/// spin about the middle axis and of a sphere is Separatrix.
Regime regimeOf(const Eigen::Vector3d& inertia, const Eigen::Vector3d& angularVelocityBody);
/// Like regimeOf(), for double-double numbers.
Regime preciseRegimeOf(const DoubleDouble3& inertia, const DoubleDouble3& angularVelocityBody);

}  // namespace rotatebook::rigid
