// Products and sums of AVX-512 that are rounded once. Inside the room only.
#pragma once

#include "study/lanes/inverse_of_root.h"
#include "study/lanes/lanes.h"

namespace rotatebook::study::lanes {

/// Returns a b + c, or c - a b, rounded once.
inline Lanes<8> fusedSum(Lanes<8> a, Lanes<8> b, Lanes<8> c) {
  for (int lane = 0; lane < 8; ++lane) c.v[lane] = __builtin_fma(a.v[lane], b.v[lane], c.v[lane]);
  return c;
}
inline Lanes<8> fusedRest(Lanes<8> a, Lanes<8> b, Lanes<8> c) {
  for (int lane = 0; lane < 8; ++lane) c.v[lane] = __builtin_fma(-a.v[lane], b.v[lane], c.v[lane]);
  return c;
}

inline Lanes<8> negativeProduct(Lanes<8> a, Lanes<8> b) {
  return fusedRest(a, b, Lanes<8>(0));  // Rounded once either way, unless it is below 1e-307.
}
inline Lanes<8> exactProductPlus(Lanes<8> a, Lanes<8> b, Lanes<8> c) {
  return fusedSum(a, b, c);
}

}  // namespace rotatebook::study::lanes
