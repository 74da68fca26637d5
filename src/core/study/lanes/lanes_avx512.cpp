#include "study/lanes/fused_avx512.h"
#include "study/lanes/kernel.h"
#include "study/lanes/kernels.h"
#ifndef __clang__
#include "study/lanes/masks_avx512.h"
#endif

namespace rotatebook::study::lanes {

const Kernels kAvx512Kernels = kernels<Pair<Lanes<8>>, 2, Pair<Lanes<8>>>();

}  // namespace rotatebook::study::lanes
