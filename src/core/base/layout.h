// A check that a program is built with the core's version, layout of types, and flags for the same
// bits. Each source that includes a type of the core notes its own when the program is loaded.
#pragma once

#include <cmath>
#include <cstddef>

#include "base/version.h"

namespace rotatebook {

/// The version and the compiler flags on which the layout of the core's types and the bits of its
/// results depend. Has no constructor, as the linker keeps one copy of those for all sources.
struct Layout {
  const char* version;         ///< Of the headers. The first member in every version.
  bool eigenDoesNotVectorize;  ///< -DEIGEN_DONT_VECTORIZE
  bool eigenIsRowMajor;        ///< -DEIGEN_DEFAULT_TO_ROW_MAJOR
  bool contractionIsOff;       ///< -ffp-contract=off: a * b + c is rounded twice.
  bool fastMath;               ///< -ffast-math
  bool associativeMath;        ///< -fassociative-math, a part of -funsafe-math-optimizations
  bool reciprocalMath;         ///< -freciprocal-math, another part of it
  bool noSignedZeros;          ///< -fno-signed-zeros, another part of it
  bool finiteMathOnly;         ///< -ffinite-math-only
};

/// Remembers `caller`, which must outlive the program's calls, unless it is the layout that the
/// core was built with. Returns whether it is.
bool noteLayout(const Layout& caller) noexcept;
/// Remembers the sizes of `type` in the core and a source, and returns whether they are equal.
bool noteSize(const char* type, std::size_t here, std::size_t caller) noexcept;

/// Throws InputError, naming the version, flag or size that differs, if a source of the program was
/// built with another layout. Every function by which a program enters the core calls it.
void requireSameLayout();
/// Like requireSameLayout(), for one source's layout.
void requireSameLayout(const Layout& caller);

/// Returns `value` after requireSameLayout(): for constructors, which read it in initialisers.
template <typename T>
const T& withSameLayout(const T& value) {
  requireSameLayout();
  return value;
}

namespace {

/// Returns the layout with which the including source is compiled. The linker can't substitute the
/// copy of another source. Where compilers define no macro for a flag, a calculation shows it.
[[maybe_unused]] Layout layoutHere() noexcept {
  Layout layout{};
  layout.version = kVersion;
#ifdef EIGEN_DONT_VECTORIZE
  layout.eigenDoesNotVectorize = true;
#endif
#ifdef EIGEN_DEFAULT_TO_ROW_MAJOR
  layout.eigenIsRowMajor = true;
#endif
  // The exact product is 1 - 2^-60; rounded before the subtraction it is 1.
  const volatile double above = 1 + 0x1p-30, below = 1 - 0x1p-30;
  layout.contractionIsOff = above * below - 1 == 0;
#ifdef __FAST_MATH__
  layout.fastMath = true;
#endif
  const volatile double tiny = 0x1p-60, one = 1, five = 5, negativeZero = -0.0;
  const double added = one;
  layout.associativeMath = tiny + added - added != 0;
  layout.reciprocalMath = five / 3.0 != 0x1.aaaaaaaaaaaabp+0;
  layout.noSignedZeros = std::signbit(negativeZero + 0.0);
#ifdef __ASSOCIATIVE_MATH__
  layout.associativeMath = true;
#endif
#ifdef __RECIPROCAL_MATH__
  layout.reciprocalMath = true;
#endif
#ifdef __NO_SIGNED_ZEROS__
  layout.noSignedZeros = true;
#endif
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
  layout.finiteMathOnly = true;
#endif
  return layout;
}

const Layout kLayoutHere = layoutHere();
[[maybe_unused]] const bool kLayoutIsSame = noteLayout(kLayoutHere);

}  // namespace
}  // namespace rotatebook
