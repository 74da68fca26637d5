// The kernels of all instruction sets. Inside the room only.
#pragma once

#include "ensemble/block.h"

namespace rotatebook::ensemble {

enum class InstructionSet;

extern const Kernels kBaseKernels;
extern const Kernels kAvx2Kernels;
extern const Kernels kAvx512Kernels;

/// Returns the kernels for an available set that has lanes.
const Kernels& kernelsFor(InstructionSet set);

}  // namespace rotatebook::ensemble
