#include "system/captured_command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"

namespace rotatebook::system {
namespace {

constexpr std::chrono::seconds kLong{60};

TEST(CapturedCommand, HasWhatAProgramPrints) {
  const auto captured = capture({"sh", "-c", "echo out; echo err >&2; exit 3"}, kLong);
  ASSERT_TRUE(captured);
  EXPECT_EQ(captured->status, 3);
  EXPECT_EQ(captured->output, "out\n");
  EXPECT_EQ(captured->problems, "err\n");
}

TEST(CapturedCommand, HasNoInput) {
  EXPECT_EQ(capture({"cat"}, kLong)->output, "");
}

TEST(CapturedCommand, KnowsTheSignalThatEndedIt) {
  EXPECT_EQ(capture({"sh", "-c", "kill -9 $$"}, kLong)->status, 137);
}

TEST(CapturedCommand, IsNoneWithoutTheProgram) {
  EXPECT_FALSE(capture({"no-such-program-here"}, kLong));
}

TEST(CapturedCommand, IsKilledIfItTakesTooLong) {
  try {
    capture({"sleep", "60"}, std::chrono::seconds(0));
    FAIL();
  } catch (const MachineError& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Transient);
  }
}

}  // namespace
}  // namespace rotatebook::system
