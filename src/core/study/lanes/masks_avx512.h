// Masks of AVX-512, which are numbers of a bit a lane: GCC 12 makes vectors of all comparisons of
// vectors, and back again. Inside the room only.
#pragma once

#include "study/lanes/lanes.h"

#ifdef __AVX512F__

namespace rotatebook::study::lanes {

template <>
struct Mask<8> {
  unsigned char bits;
};

// Numbers of comparisons in the instruction vcmppd, which are false of NaN.
enum class Comparison { Equal = 0, Less = 17, LessOrEqual = 18 };

template <Comparison kComparison>
Mask<8> compared(Lanes<8> a, Lanes<8> b) {
  constexpr int kAsItIs = 4;  // the handling of exceptions
  return {static_cast<unsigned char>(__builtin_ia32_cmppd512_mask(
      a.v, b.v, static_cast<int>(kComparison), static_cast<unsigned char>(-1), kAsItIs))};
}

inline Mask<8> operator<(Lanes<8> a, Lanes<8> b) {
  return compared<Comparison::Less>(a, b);
}
inline Mask<8> operator<=(Lanes<8> a, Lanes<8> b) {
  return compared<Comparison::LessOrEqual>(a, b);
}
inline Mask<8> operator==(Lanes<8> a, Lanes<8> b) {
  return compared<Comparison::Equal>(a, b);
}
inline Mask<8> isNot(Mask<8> mask) {
  return {static_cast<unsigned char>(~mask.bits)};
}
inline Mask<8> both(Mask<8> a, Mask<8> b) {
  return {static_cast<unsigned char>(a.bits & b.bits)};
}
inline Lanes<8> chosen(Mask<8> mask, Lanes<8> yes, Lanes<8> no) {
  return __builtin_ia32_blendmpd_512_mask(no.v, yes.v, mask.bits);
}
inline void storeMask(Mask<8> mask, bool* to) {
  for (int lane = 0; lane < 8; ++lane) to[lane] = (mask.bits >> lane & 1) != 0;
}
inline bool isAny(Mask<8> mask) {
  return mask.bits != 0;
}
/// Returns, body by body, the larger size of two numbers, of which a NaN is none.
inline Lanes<8> largerSize(Lanes<8> a, Lanes<8> b) {
  constexpr int kLargerSize = 11;  // of vrangepd
  constexpr int kAsItIs = 4;
  return __builtin_ia32_rangepd512_mask(a.v, b.v, kLargerSize, a.v, static_cast<unsigned char>(-1),
                                        kAsItIs);
}

}  // namespace rotatebook::study::lanes

#endif
