#include "base/units.h"

#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/number_text.h"

namespace rotatebook {
namespace {

using ::testing::ElementsAre;

constexpr double kPiOver180 = std::numbers::pi / 180;

TEST(Units, ConvertToTheSi) {
  EXPECT_EQ(parseQuantity("18.8 cm", Dimension::Length), 0.188);
  EXPECT_EQ(parseQuantity("3mm", Dimension::Length), 0.003);
  EXPECT_EQ(parseQuantity("  2.5 m ", Dimension::Length), std::nullopt);
  EXPECT_EQ(parseQuantity("2.5\tm ", Dimension::Length), 2.5);
  EXPECT_EQ(parseQuantity("9.1 in", Dimension::Length), 0.23114);
  EXPECT_EQ(parseQuantity("800 g", Dimension::Mass), 0.8);
  EXPECT_EQ(parseQuantity("1.2e0 kg", Dimension::Mass), 1.2);
  EXPECT_EQ(parseQuantity("250 ms", Dimension::Time), 0.25);
  EXPECT_EQ(parseQuantity("1.5 min", Dimension::Time), 90);
  EXPECT_EQ(parseQuantity("-0.02 rad", Dimension::Angle), -0.02);
  EXPECT_EQ(parseQuantity("1 deg", Dimension::Angle), kPiOver180);
  EXPECT_EQ(parseQuantity("1°", Dimension::Angle), kPiOver180);
  EXPECT_EQ(parseQuantity("360 °/s", Dimension::AngularVelocity), 2 * std::numbers::pi);
  EXPECT_EQ(parseQuantity("0.25 turn", Dimension::Angle), std::numbers::pi / 2);
  EXPECT_EQ(parseQuantity("60 rpm", Dimension::AngularVelocity), 2 * std::numbers::pi);
  EXPECT_EQ(parseQuantity("2 turn/s", Dimension::AngularVelocity), 4 * std::numbers::pi);
  EXPECT_EQ(parseQuantity("360 deg/s", Dimension::AngularVelocity), 2 * std::numbers::pi);
  EXPECT_EQ(parseQuantity("6 rad/s", Dimension::AngularVelocity), 6);
}

// A product with 0.01 differs in the last digit from one number in seven.
TEST(Units, GiveTheDoublesThatDecimalsInSiGive) {
  int products = 0;
  for (int tenths = -1000; tenths <= 30'000; ++tenths) {
    const std::string number = shortestText(tenths / 10.0);
    EXPECT_EQ(parseQuantity(number + " cm", Dimension::Length), tenths / 1000.0) << number;
    EXPECT_EQ(parseQuantity(number + " g", Dimension::Mass), tenths / 10'000.0) << number;
    EXPECT_EQ(parseQuantity(number + " in", Dimension::Length), tenths * 254 / 100'000.0) << number;
    products += tenths / 10.0 * 0.01 == tenths / 1000.0;
  }
  EXPECT_LT(products, 27'000);  // measured 25981 of 31001
}

TEST(Units, ConvertAnyFormOfANumber) {
  for (const char* text : {"1880e-1mm", "0.0188E+1 m", ".188 m", "18.80000 cm", "00018.8 cm",
                           "0.000000188e8 cm", "188.e-1 cm"}) {
    EXPECT_EQ(parseQuantity(text, Dimension::Length), 0.188) << text;
  }
  EXPECT_EQ(parseQuantity("0e99999999999 cm", Dimension::Length), std::nullopt);
  EXPECT_EQ(parseQuantity("1e308 min", Dimension::Time), std::nullopt);
  EXPECT_EQ(parseQuantity("1e308 turn", Dimension::Angle), std::nullopt);
  EXPECT_EQ(parseQuantity("0." + std::string(500, '0') + "1e501 m", Dimension::Length), 1);
}

TEST(Units, RefuseWhatIsNoQuantity) {
  for (const char* text : {"", "1", "cm", "1 cm cm", "1,5 cm", "1 kg", "1 CM", "x cm", "+1 cm",
                           "nan cm", "inf cm", "0x1p3 cm", "1 c m", "1e cm", "- 1 cm"}) {
    EXPECT_EQ(parseQuantity(text, Dimension::Length), std::nullopt) << text;
  }
}

TEST(Units, AreListedThatOfTheSiFirst) {
  EXPECT_THAT(unitsOf(Dimension::Length), ElementsAre("m", "cm", "mm", "km", "in"));
  EXPECT_THAT(unitsOf(Dimension::Mass), ElementsAre("kg", "g"));
  EXPECT_THAT(unitsOf(Dimension::Time), ElementsAre("s", "ms", "min"));
  EXPECT_THAT(unitsOf(Dimension::Angle), ElementsAre("rad", "deg", "turn", "°"));
  EXPECT_THAT(unitsOf(Dimension::AngularVelocity),
              ElementsAre("rad/s", "deg/s", "°/s", "turn/s", "rpm"));
}

}  // namespace
}  // namespace rotatebook
