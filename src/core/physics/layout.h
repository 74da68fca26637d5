// A check that a program which uses the core was built with the same layout of its types.
#pragma once

#include <cstddef>

#include <Eigen/Core>

#include "physics/motion_settings.h"
#include "physics/trajectory.h"

namespace rotatebook::physics {

/// The compiler flags on which the layout of the core's types and the bits of its results depend,
/// and the resulting sizes. [bytes]
struct Layout {
  bool eigenVectorizes = true;     ///< EIGEN_DONT_VECTORIZE isn't defined.
  bool fastMath = false;           ///< -ffast-math
  bool contractsProducts = false;  ///< a * b + c is rounded once, without -ffp-contract=off.
  std::size_t sample = sizeof(Sample);
  std::size_t trajectory = sizeof(Trajectory);
  std::size_t motionSettings = sizeof(MotionSettings);
};

namespace {

/// Returns the layout with which the including source is compiled. Each source has its own copy, so
/// that the linker can't substitute another's.
[[maybe_unused]] Layout layoutHere() {
  Layout layout;
#ifdef EIGEN_DONT_VECTORIZE
  layout.eigenVectorizes = false;
#endif
#ifdef __FAST_MATH__
  layout.fastMath = true;
#endif
  // The exact product is 1 - 2^-60; rounded before the subtraction it is 1.
  const volatile double above = 1 + 0x1p-30, below = 1 - 0x1p-30;
  const volatile double left = above * below - 1;
  layout.contractsProducts = left != 0;
  return layout;
}

}  // namespace

/// Throws InputError, naming the first flag or size that differs, unless `caller` is the layout
/// that the core was built with. Every function by which a program enters the core calls it.
void requireSameLayout(const Layout& caller);

}  // namespace rotatebook::physics
