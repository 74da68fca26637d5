#include "ensemble/kernel.h"
#include "ensemble/kernels.h"
#ifndef __clang__
#include "ensemble/masks_avx512.h"
#endif

namespace rotatebook::ensemble {

const Kernels kAvx512Kernels = kernels<Pair<Pair<Lanes<8>>>, Pair<Lanes<8>>>();

}  // namespace rotatebook::ensemble
