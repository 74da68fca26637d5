#include "image/srgb.h"

#include <gtest/gtest.h>

#include "image/srgb_formula.h"

namespace rotatebook::image {
namespace {

// IEC 61966-2-1, by hand: 188 is the number of half the light, 13.6 % of it has the number 104.
TEST(Srgb, FollowsTheStandard) {
  constexpr double kBound = 1e-4;  // measured 4e-5
  EXPECT_EQ(linearByFormula(0), 0);
  EXPECT_EQ(linearByFormula(255), 1);
  EXPECT_NEAR(linearByFormula(188), 0.5028, kBound);
  EXPECT_NEAR(linearByFormula(104), 0.1384, kBound);
  EXPECT_NEAR(linearByFormula(10), 10 / 255.0 / 12.92, 1e-12);
  EXPECT_EQ(srgbFromLinear(0.5), 188);
  EXPECT_EQ(srgbFromLinear(0.002), 7);  // 255 * 12.92 * 0.002 = 6.6
}

TEST(Srgb, ReadsBackEveryNumber) {
  for (int number = 0; number < 256; ++number) {
    const auto encoded = static_cast<std::uint8_t>(number);
    EXPECT_EQ(srgbFromLinear(linearByFormula(encoded)), encoded);
  }
}

TEST(Srgb, HasLightAsWholeNumbers) {
  EXPECT_EQ(linearFromSrgb(0), 0U);
  EXPECT_EQ(linearFromSrgb(255), kMaxLinear);
  for (int number = 0; number < 256; ++number) {
    const auto encoded = static_cast<std::uint8_t>(number);
    EXPECT_NEAR(linearFromSrgb(encoded), kMaxLinear * linearByFormula(encoded), 0.5);
    EXPECT_EQ(srgbFromLinear(linearFromSrgb(encoded)), encoded);
  }
  for (std::uint32_t light = 0; light <= kMaxLinear; ++light) {
    EXPECT_EQ(srgbFromLinear(light), srgbFromLinear(static_cast<double>(light) / kMaxLinear));
  }
}

}  // namespace
}  // namespace rotatebook::image
