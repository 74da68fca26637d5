#include "base/json.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace rotatebook {
namespace {

TEST(JsonString, EndsNeitherItselfNorAScript) {
  EXPECT_EQ(jsonString("a\"b\\c\n\x01\x7f</script>ω"), R"("a\"b\\c\n\u0001\u007F\u003C/script>ω")");
  EXPECT_EQ(jsonString(""), "\"\"");
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
