#include "study/lanes/kernel.h"
#include "study/lanes/kernels.h"

namespace rotatebook::study::lanes {

const Kernels kAvx2Kernels = kernels<Lanes<4>, 4, Pair<Lanes<4>>>();

}  // namespace rotatebook::study::lanes
