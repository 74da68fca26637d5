// The choice between a processor's vectors.
#include "image/wide_vectors.h"

#include <cstdlib>

#include <gtest/gtest.h>

namespace rotatebook::image {
namespace {

TEST(WideVectors, AreRefusedByTheEnvironment) {
  setenv("ROTATEBOOK_NO_AVX2", "1", 1);
  EXPECT_FALSE(usesAvx2());
  unsetenv("ROTATEBOOK_NO_AVX2");
}

}  // namespace
}  // namespace rotatebook::image
