#include "base/rgb.h"

#include <gtest/gtest.h>

namespace rotatebook {
namespace {

TEST(Rgb, ReadsSixDigitsAndTwoNames) {
  EXPECT_EQ(parseRgb("#2b5d8a"), (Rgb{0x2b, 0x5d, 0x8a}));
  EXPECT_EQ(parseRgb("#00FFaB"), (Rgb{0, 255, 0xab}));
  EXPECT_EQ(parseRgb("white"), (Rgb{255, 255, 255}));
  EXPECT_EQ(parseRgb("black"), (Rgb{0, 0, 0}));
}

TEST(Rgb, RefusesWhatIsNoColour) {
  for (const char* text : {"", "#", "#fff", "2b5d8a", "#2b5d8", "#2b5d8a0", "#2b5d8g", "#-b5d8a",
                           "# b5d8a", "#0x1234", "White", "blue"}) {
    EXPECT_FALSE(parseRgb(text)) << text;
  }
}

TEST(Rgb, IsWrittenAsItIsRead) {
  EXPECT_EQ(textOf({0x0b, 0x5d, 0xfa}), "#0b5dfa");
  EXPECT_EQ(parseRgb(textOf({1, 2, 3})), (Rgb{1, 2, 3}));
}

TEST(Rgb, HasALuminance) {
  EXPECT_DOUBLE_EQ(luminanceOf(1, 1, 1), 1);
  EXPECT_EQ(luminanceOf(0, 0, 0), 0);
  EXPECT_GT(luminanceOf(0, 1, 0), luminanceOf(1, 0, 1));
}

}  // namespace
}  // namespace rotatebook
