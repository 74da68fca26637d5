#include "study/lanes/kernel.h"
#include "study/lanes/kernels.h"

namespace rotatebook::study::lanes {

const Kernels kBaseKernels = kernels<Pair<Lanes<2>>, 2, Pair<Lanes<2>>>();

}  // namespace rotatebook::study::lanes
