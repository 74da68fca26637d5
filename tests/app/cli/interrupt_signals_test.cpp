// The effect of signals on this very process.
#include <csignal>
#include <unistd.h>

#include <gtest/gtest.h>

#include "cli/interrupt.h"

namespace rotatebook::cli {
namespace {

using ::testing::ExitedWithCode;
using ::testing::KilledBySignal;

TEST(CatchInterruptsDeathTest, FirstIsKeptAsAStatus) {
  EXPECT_EXIT(
      {
        const auto& interrupted = catchInterrupts();
        std::raise(SIGTERM);
        _exit(interrupted ? interruptStatus() : 0);
      },
      ExitedWithCode(143), "");
}

TEST(CatchInterruptsDeathTest, SecondEndsTheProcessWhicheverItIs) {
  for (const int second : {SIGINT, SIGTERM, SIGHUP}) {
    EXPECT_EXIT(
        {
          catchInterrupts();
          std::raise(SIGTERM);
          std::raise(second);
          _exit(0);
        },
        KilledBySignal(second), "");
  }
}

TEST(CatchInterruptsDeathTest, SecondThatIsIgnoredStaysSo) {
  EXPECT_EXIT(
      {
        std::signal(SIGHUP, SIG_IGN);
        catchInterrupts();
        std::raise(SIGTERM);
        std::raise(SIGHUP);
        _exit(interruptStatus());
      },
      ExitedWithCode(143), "");
}

}  // namespace
}  // namespace rotatebook::cli
