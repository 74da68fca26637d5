#include "ensemble/kernel.h"
#include "ensemble/kernels.h"

namespace rotatebook::ensemble {

const Kernels kAvx2Kernels = kernels<Pair<Pair<Lanes<4>>>, Pair<Lanes<4>>>();

}  // namespace rotatebook::ensemble
