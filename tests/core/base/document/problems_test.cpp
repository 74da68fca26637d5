#include "base/document/problems.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/document/errors.h"

namespace rotatebook::document {
namespace {

/// The message of problems at those locations, noted in that order.
std::string messageOf(const std::vector<std::string>& locations) {
  Problems problems;
  for (const std::string& location : locations) {
    problems.note([&] { failAt(location, "wrong"); });
  }
  return errorOf([&] { problems.throwIfAny(); });
}

TEST(Problems, AreThrownOnlyIfThereAreAny) {
  EXPECT_EQ(messageOf({}), "no error");
}

TEST(Problems, ComeInTheOrderOfTheFileAndThenOfOverrides) {
  EXPECT_EQ(messageOf({"--set b=1", "f:10:1", "f:9:20", "--set a=1", "f:9:3", "f"}),
            "f: wrong\n  f:9:3: wrong\n  f:9:20: wrong\n  f:10:1: wrong\n  --set a=1: wrong\n  "
            "--set b=1: wrong");
}

TEST(Problems, AtOneLocationAreReportedOnce) {
  EXPECT_EQ(messageOf({"f:1:1", "f:2:1", "f:1:1"}), "f:1:1: wrong\n  f:2:1: wrong");
}

TEST(Problems, AreAtMostTwentyInAMessage) {
  std::vector<std::string> locations;
  for (int line = 1; line <= 22; ++line) locations.push_back("f:" + std::to_string(line) + ":1");
  const std::string message = messageOf(locations);
  EXPECT_TRUE(message.ends_with("f:20:1: wrong\n  and 2 more")) << message;
}

}  // namespace
}  // namespace rotatebook::document
