// Numbers that hold a double for each of several bodies, in one of the processor's vectors. What is
// compiled for one instruction set has a width that no other has, so that the linker never takes
// one's functions for another's; each is a template of the width. Inside the room only.
#pragma once

namespace rotatebook::study::lanes {

/// The vector types of a width, written out, because GCC ignores a size that depends on a
/// template's parameter.
template <int kWidth>
struct VectorTypes;

#define ROTATEBOOK_VECTOR_TYPES(width)                              \
  template <>                                                       \
  struct VectorTypes<width> {                                       \
    typedef double Doubles __attribute__((vector_size(width * 8))); \
    typedef long long Bits __attribute__((vector_size(width * 8))); \
  }
ROTATEBOOK_VECTOR_TYPES(2);
ROTATEBOOK_VECTOR_TYPES(4);
ROTATEBOOK_VECTOR_TYPES(8);
#undef ROTATEBOOK_VECTOR_TYPES

/// For which of the bodies a condition holds: all bits of a lane, or none.
template <int kWidth>
struct Mask {
  typename VectorTypes<kWidth>::Bits bits;
};

template <int kWidth>
struct Lanes {
  using Doubles = typename VectorTypes<kWidth>::Doubles;
  using Bits = typename VectorTypes<kWidth>::Bits;

  Doubles v;

  Lanes() = default;
  Lanes(Doubles doubles) : v(doubles) {}
  /// Gives each the number.
  explicit Lanes(double number) : v(number - Doubles{}) {}

  friend Lanes operator+(Lanes a, Lanes b) { return a.v + b.v; }
  friend Lanes operator-(Lanes a, Lanes b) { return a.v - b.v; }
  friend Lanes operator*(Lanes a, Lanes b) { return a.v * b.v; }
  friend Lanes operator/(Lanes a, Lanes b) { return a.v / b.v; }
};

template <int kWidth>
Mask<kWidth> operator<(Lanes<kWidth> a, Lanes<kWidth> b) {
  return {a.v < b.v};
}
template <int kWidth>
Mask<kWidth> operator<=(Lanes<kWidth> a, Lanes<kWidth> b) {
  return {a.v <= b.v};
}
template <int kWidth>
Mask<kWidth> operator==(Lanes<kWidth> a, Lanes<kWidth> b) {
  return {a.v == b.v};
}
template <int kWidth>
Mask<kWidth> isNot(Mask<kWidth> mask) {
  return {~mask.bits};
}
template <int kWidth>
Mask<kWidth> both(Mask<kWidth> a, Mask<kWidth> b) {
  return {a.bits & b.bits};
}
template <int kWidth>
Lanes<kWidth> chosen(Mask<kWidth> mask, Lanes<kWidth> yes, Lanes<kWidth> no) {
  return mask.bits ? yes.v : no.v;
}
template <int kWidth>
constexpr int laneCount(Mask<kWidth> /*mask*/) {
  return kWidth;
}
/// Stores whether the condition holds, for each body.
template <int kWidth>
void storeMask(Mask<kWidth> mask, bool* to) {
  for (int lane = 0; lane < kWidth; ++lane) to[lane] = mask.bits[lane] != 0;
}
template <int kWidth>
bool isAny(Mask<kWidth> mask) {
#if defined(__AVX__)
  if constexpr (kWidth == 4) {
    return __builtin_ia32_movmskpd256(reinterpret_cast<typename Lanes<4>::Doubles>(mask.bits)) != 0;
  }
#elif defined(__SSE2__)
  if constexpr (kWidth == 2) {
    return __builtin_ia32_movmskpd(reinterpret_cast<typename Lanes<2>::Doubles>(mask.bits)) != 0;
  }
#endif
  long long any = 0;
  for (int lane = 0; lane < kWidth; ++lane) any |= mask.bits[lane];
  return any != 0;
}

template <int kWidth>
bool isAll(Mask<kWidth> mask) {
  return !isAny(isNot(mask));
}
template <int kWidth>
Mask<kWidth> operator>(Lanes<kWidth> a, Lanes<kWidth> b) {
  return b < a;
}
template <int kWidth>
Lanes<kWidth> magnitude(Lanes<kWidth> a) {
  using Bits = typename Lanes<kWidth>::Bits;
  const Bits size = reinterpret_cast<Bits>(a.v) & 0x7fffffffffffffffLL;
  return reinterpret_cast<typename Lanes<kWidth>::Doubles>(size);
}
template <int kWidth>
Lanes<kWidth> rootOf(Lanes<kWidth> a) {
  for (int lane = 0; lane < kWidth; ++lane) a.v[lane] = __builtin_sqrt(a.v[lane]);
  return a;
}
template <int kWidth>
bool isAnyLarger(Lanes<kWidth> x, double bound) {
  return isAny(Lanes<kWidth>(bound) < magnitude(x));
}
template <int kWidth>
Lanes<kWidth> exactProductPlus(Lanes<kWidth> a, Lanes<kWidth> b, Lanes<kWidth> c) {
  return a * b + c;
}
/// Returns 0 - a b.
template <int kWidth>
Lanes<kWidth> negativeProduct(Lanes<kWidth> a, Lanes<kWidth> b) {
  return Lanes<kWidth>(0) - a * b;
}

}  // namespace rotatebook::study::lanes
