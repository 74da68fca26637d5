#include "study/lanes/kernel.h"
#include "study/lanes/kernels.h"

namespace rotatebook::study::lanes {

const Kernels kAvx2Kernels = kernels<Pair<Pair<Lanes<4>>>, Pair<Lanes<4>>>();

}  // namespace rotatebook::study::lanes
