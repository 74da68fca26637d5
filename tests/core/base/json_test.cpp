#include "base/json.h"

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace rotatebook {
namespace {

TEST(JsonText, IsUtf8WhateverItIsMadeOf) {
  EXPECT_EQ(jsonText("a\xff\xc3 \"\xe2\x82\""), "\"a\uFFFD\uFFFD \\\"\uFFFD\\\"\"");
  EXPECT_EQ(jsonText("Größe 書 🕮"), "\"Größe 書 🕮\"");
}

TEST(JsonText, HasNullForWhatIsNoNumber) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(jsonText({{"nan", std::numeric_limits<double>::quiet_NaN()},
                      {"infinite", -kInfinity},
                      {"none", orNull(std::optional<double>())},
                      {"some", orNull(std::optional(0.1))},
                      {"empty", orNull("")},
                      {"text", orNull("a")}}),
            R"({"nan":null,"infinite":null,"none":null,"some":0.1,"empty":null,"text":"a"})");
}

TEST(JsonText, HoldsMembersInTheirOrderOnOneLine) {
  EXPECT_EQ(jsonText({{"b", "1\n"}, {"a", true}, {"list", {1, 0.5}}}),
            R"({"b":"1\n","a":true,"list":[1,0.5]})");
}

TEST(JsonArray, HoldsWhatIsMadeOfItems) {
  const auto twice = [](int number) { return 2 * number; };
  EXPECT_EQ(arrayOf(std::vector{1, 2}, twice), Json::array({2, 4}));
  EXPECT_EQ(jsonText(arrayOf(std::vector<int>{}, twice)), "[]");
  EXPECT_EQ(vectorJson(std::array{1.0, 0.5, 2.0}), Json::array({1.0, 0.5, 2.0}));
}

TEST(JsonNumber, IsRoundedToSoManyDigits) {
  EXPECT_EQ(jsonText(roundedJson(2.0 / 3, 6)), "0.666667");
  EXPECT_EQ(jsonText(roundedJson(1, 6)), "1");
  EXPECT_EQ(jsonText(roundedJson(std::numeric_limits<double>::infinity(), 6)), "null");
}

TEST(JsonResult, IsKnownByItsBeginning) {
  const std::string text = jsonText({{"result", "map"}, {"name", "a"}});
  EXPECT_TRUE(isResultOf("map", text));
  EXPECT_FALSE(isResultOf("clip", text));
  EXPECT_FALSE(isResultOf("map", R"({"name":"a","result":"map"})"));
}

}  // namespace
}  // namespace rotatebook
