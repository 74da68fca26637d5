#include "base/document/value_reader.h"

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "base/document/errors.h"

namespace rotatebook::document {
namespace {

/// The message of what `read` does with the root of `text`.
template <typename Read>
std::string errorIn(const std::string& text, const Read& read) {
  const TomlNode root = parseToml(text, "f");
  return errorOf([&] { read(ValueReader(root, "")); });
}

TEST(ValueReader, ReadsEachKindOfValue) {
  const TomlNode root = parseToml("a = 1\nb = 2.5\nc = 'x'\n[s]\ne = [1, 2]", "f");
  const ValueReader file(root, "");
  EXPECT_EQ(file.find("a")->integer(0, 1), 1);
  EXPECT_EQ(file.find("a")->number(kPositive), 1);
  EXPECT_EQ(file.find("b")->number(kNumber), 2.5);
  EXPECT_EQ(file.find("c")->text(1), "x");
  EXPECT_EQ(file.find("c")->choice(std::vector<std::string_view>{"w", "x"}), 1U);
  EXPECT_EQ(file.find("s", "e")->elements(2, "a pair")[1].integer(0, 9), 2);
  EXPECT_FALSE(file.find("s", "f"));
  EXPECT_FALSE(file.find("t", "e"));
}

TEST(ValueReader, NamesWhatIsExpectedAndWhatIsFound) {
  const auto number = [](const ValueReader& file) { file.find("s", "a")->number(kPositive); };
  EXPECT_EQ(errorIn("s.a = -1", number), "f:1:7: s.a must be a positive number, not -1");
  EXPECT_EQ(errorIn("s.a = nan", number), "f:1:7: s.a must be a positive number, not nan");
  EXPECT_EQ(errorIn("s.a = 'x'", number), "f:1:7: s.a must be a positive number, not \"x\"");
  const auto choice = [](const ValueReader& file) {
    file.find("a")->choice(std::vector<std::string_view>{"matrix", "exact"});
  };
  EXPECT_EQ(errorIn("a = 'matrx'", choice),
            "f:1:5: a must be \"matrix\" or \"exact\", not \"matrx\"; did you mean \"matrix\"?");
}

TEST(ValueReader, RefusesUnknownKeysAndGoesOn) {
  const auto read = [](const ValueReader& file) {
    file.readTable({{"first", [](const ValueReader& value) { value.integer(0, 1); }},
                    {"second", [](const ValueReader&) {}}});
  };
  EXPECT_EQ(errorIn("first = 2\nsecnd = 1\n", read),
            "f:1:9: first must be an integer from 0 to 1, not 2\n"
            "  f:2:1: unknown key \"secnd\"; did you mean \"second\"?");
  EXPECT_EQ(errorIn("[xyz]\n", read),
            "f:1:2: unknown section \"xyz\"; valid are \"first\" and \"second\"");
}

TEST(ValueReader, GivesTheProblemsOfOthersItsLocation) {
  const auto check = [](const ValueReader& file) {
    failAtValue(*file.find("a"), [] { throw InputError("too fast"); });
  };
  EXPECT_EQ(errorIn("a = 1", check), "f:1:5: too fast");
}

}  // namespace
}  // namespace rotatebook::document
