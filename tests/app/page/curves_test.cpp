#include "page/curves.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rotatebook::page {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(CurvesSvg, DrawsEachCurveInItsColourAndNoWords) {
  const std::string text = curvesSvg({{{0, 0}, {1, 10}}, {{0, 5}, {1, 5}}}).text;
  EXPECT_THAT(text, AllOf(HasSubstr("stroke:var(--series-1)\" d=\"M26 109L222 18\""),
                          HasSubstr("stroke:var(--series-2)\" d=\"M26 63.5L222 63.5\""),
                          HasSubstr("aria-hidden"), Not(HasSubstr("<text"))));
}

TEST(CurvesSvg, LeavesOutWhatIsNotFinite) {
  const std::string text =
      curvesSvg({{{0, kInfinity}}, {{0, 1}, {-kInfinity, 2}, {2, 3}}, {}}).text;
  EXPECT_THAT(text, AllOf(HasSubstr("--series-2)\" d=\"M26 109L222 18\""),
                          Not(HasSubstr("--series-1")), Not(HasSubstr("--series-3"))));
}

}  // namespace
}  // namespace rotatebook::page
