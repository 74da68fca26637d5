#include "ensemble/kernel.h"
#include "ensemble/kernels.h"

namespace rotatebook::ensemble {

const Kernels kBaseKernels = kernels<Pair<Pair<Lanes<2>>>, Pair<Lanes<2>>>();

}  // namespace rotatebook::ensemble
