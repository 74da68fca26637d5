#include "base/json.h"

#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace rotatebook {
namespace {

TEST(JsonString, EndsNeitherItselfNorAScript) {
  EXPECT_EQ(jsonString("a\"b\\c\n\x01\x7f</script>ω"), R"("a\"b\\c\n\u0001\u007F\u003C/script>ω")");
  EXPECT_EQ(jsonString(""), "\"\"");
}

TEST(JsonString, IsUtf8WhateverItIsMadeOf) {
  EXPECT_EQ(jsonString("a\xff\xc3 \"\xe2\x82\""), "\"a\uFFFD\uFFFD \\\"\uFFFD\uFFFD\\\"\"");
  EXPECT_EQ(jsonString("Größe 書 🕮"), "\"Größe 書 🕮\"");
}

TEST(JsonObject, HasNullForWhatIsNoNumber) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(JsonObject()
                .addNumber("nan", std::numeric_limits<double>::quiet_NaN())
                .addNumber("infinite", -kInfinity)
                .addNumberOrNull("none", {})
                .addNumberOrNull("some", 0.1)
                .addNumberOrNull("infinite too", kInfinity)
                .addInteger("integer", 100'000)
                .text(),
            R"({"nan": null, "infinite": null, "none": null, "some": 0.1, "infinite too": null, )"
            R"("integer": 100000})");
}

TEST(JsonArray, HoldsValues) {
  EXPECT_EQ(jsonArray({}), "[]");
  EXPECT_EQ(jsonArrayOf(std::vector<std::string>{"a", "b"}, jsonString), R"(["a", "b"])");
}

TEST(JsonObject, HoldsMembersInTheirOrder) {
  EXPECT_EQ(JsonObject().text(), "{}");
  EXPECT_EQ(JsonObject()
                .addString("b", "1")
                .addStringOrNull("a", "")
                .addNumber("number", 0.5)
                .addBool("bool", true)
                .add("list", "[1]")
                .text(),
            R"({"b": "1", "a": null, "number": 0.5, "bool": true, "list": [1]})");
}

}  // namespace
}  // namespace rotatebook
