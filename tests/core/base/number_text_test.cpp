#include "base/number_text.h"

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace rotatebook {
namespace {

TEST(ShortestText, ReadsBackToTheSameBits) {
  for (const double value : {0.1, 1.0 / 3, -2.5e-300, std::nextafter(1.0, 2.0), 1e22, -0.0}) {
    const double back = std::stod(shortestText(value));
    EXPECT_EQ(back, value) << shortestText(value);
    EXPECT_EQ(std::signbit(back), std::signbit(value));
  }
}

TEST(ShortestText, IsShort) {
  EXPECT_EQ(shortestText(0.1), "0.1");
  EXPECT_EQ(shortestText(60), "60");
}

TEST(ShortestText, NamesWhatIsNotFinite) {
  EXPECT_EQ(shortestText(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(shortestText(std::numeric_limits<double>::quiet_NaN()), "nan");
}

TEST(RoundedText, HasSoManyDigitsAtMost) {
  EXPECT_EQ(roundedText(2.0 / 3, 6), "0.666667");
  EXPECT_EQ(roundedText(-0.9999999999999998, 9), "-1");
  EXPECT_EQ(roundedText(1.5, 7), "1.5");
  EXPECT_EQ(roundedText(1234567, 3), "1.23e+06");
  EXPECT_EQ(roundedText(1e-300 / 3, 17).size(), 23U);
  EXPECT_EQ(roundedText(std::numeric_limits<double>::quiet_NaN(), 3), "nan");
}

}  // namespace
}  // namespace rotatebook
