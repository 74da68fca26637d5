// The kernels of all instruction sets. Inside the room only.
#pragma once

#include "study/lanes/block.h"

namespace rotatebook::study::lanes {

enum class InstructionSet;

extern const Kernels kBaseKernels;
extern const Kernels kAvx2Kernels;
extern const Kernels kAvx512Kernels;

/// Returns the kernels for an available set that has lanes.
const Kernels& kernelsFor(InstructionSet set);

}  // namespace rotatebook::study::lanes
