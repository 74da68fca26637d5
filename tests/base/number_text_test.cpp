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

}  // namespace
}  // namespace rotatebook
