// The one choice between a processor's vectors.
#pragma once

namespace rotatebook::image {

/// Returns whether code for AVX2 is taken: where the processor has it, unless the environment's
/// variable ROTATEBOOK_NO_AVX2 isn't empty. Pictures are the same with and without.
bool usesAvx2();

}  // namespace rotatebook::image
