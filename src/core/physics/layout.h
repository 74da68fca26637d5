// Whether a program that uses the core was built with the same layout of its types as the core.
#pragma once

#include <cstddef>

#include <Eigen/Core>

#include "physics/motion_settings.h"
#include "physics/trajectory.h"

namespace rotatebook::physics {

/// The flags on which the layout of the core's types and the bits of its results depend, and the
/// sizes that they lead to. [bytes]
struct Layout {
  bool eigenVectorizes = true;     ///< EIGEN_DONT_VECTORIZE isn't defined.
  bool fastMath = false;           ///< -ffast-math
  bool contractsProducts = false;  ///< a * b + c is rounded once: no -ffp-contract=off.
  std::size_t sample = sizeof(Sample);
  std::size_t trajectory = sizeof(Trajectory);
  std::size_t motionSettings = sizeof(MotionSettings);
};

namespace {

/// The layout that this source is compiled with. Of each source its own, so that no linker takes
/// another one's.
[[maybe_unused]] Layout layoutHere() {
  Layout layout;
#ifdef EIGEN_DONT_VECTORIZE
  layout.eigenVectorizes = false;
#endif
#ifdef __FAST_MATH__
  layout.fastMath = true;
#endif
  // The product is 1 - 2^-60, which one rounding more makes 1.
  const volatile double above = 1 + 0x1p-30, below = 1 - 0x1p-30;
  const volatile double left = above * below - 1;
  layout.contractsProducts = left != 0;
  return layout;
}

}  // namespace

/// Throws InputError, naming the first flag or size that differs, if `caller` isn't the layout that
/// the core was built with. Each function by which a program enters the core calls it.
void requireSameLayout(const Layout& caller);

}  // namespace rotatebook::physics
