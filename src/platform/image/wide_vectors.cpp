#include "image/wide_vectors.h"

#include <cstdlib>

namespace rotatebook::image {

bool usesAvx2() {
#ifdef __x86_64__
  const char* refused = std::getenv("ROTATEBOOK_NO_AVX2");
  return __builtin_cpu_supports("avx2") && (refused == nullptr || *refused == '\0');
#else
  return false;
#endif
}

}  // namespace rotatebook::image
