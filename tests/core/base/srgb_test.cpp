#include "base/srgb.h"

#include <gtest/gtest.h>

namespace rotatebook {
namespace {

// IEC 61966-2-1, by hand: 188 is the number of half the light, 13.6 % of it has the number 104.
TEST(SrgbCurve, FollowsTheStandard) {
  constexpr double kBound = 1e-4;  // measured 4e-5
  EXPECT_EQ(decodedSrgb(0), 0);
  EXPECT_EQ(decodedSrgb(1), 1);
  EXPECT_NEAR(decodedSrgb(188 / 255.0), 0.5028, kBound);
  EXPECT_NEAR(decodedSrgb(104 / 255.0), 0.1384, kBound);
  EXPECT_EQ(encodedSrgb(0), 0);
  EXPECT_NEAR(encodedSrgb(1), 1, 1e-15);
  EXPECT_NEAR(255 * encodedSrgb(0.5), 187.52, 0.01);
}

TEST(SrgbCurve, IsReadBack) {
  for (int number = 0; number < 256; ++number) {
    const double value = number / 255.0;
    EXPECT_NEAR(encodedSrgb(decodedSrgb(value)), value, 1e-7);
  }
}

}  // namespace
}  // namespace rotatebook
