#include "study/lanes/kernel.h"
#include "study/lanes/kernels.h"
#ifndef __clang__
#include "study/lanes/masks_avx512.h"
#endif

namespace rotatebook::study::lanes {

const Kernels kAvx512Kernels = kernels<Pair<Pair<Lanes<8>>>, Pair<Lanes<8>>>();

}  // namespace rotatebook::study::lanes
