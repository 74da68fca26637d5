// The one choice between a processor's vectors.
#pragma once

/// Compiles a function for AVX2, where there is such; `usesAvx2() ? &xByAvx2 : &xByBase` chooses.
#ifdef __x86_64__
#define ROTATEBOOK_AVX2 [[gnu::target("avx2")]]
#else
#define ROTATEBOOK_AVX2
#endif

namespace rotatebook::image {

/// Returns whether code for AVX2 is taken: where the processor has it, unless the environment's
/// variable ROTATEBOOK_NO_AVX2 isn't empty. Pictures are the same with and without.
bool usesAvx2();

}  // namespace rotatebook::image
