#include "system/child_process.h"

#include <csignal>
#include <optional>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

namespace rotatebook::system {
namespace {

using std::chrono::seconds;

/// Standard streams in memory.
struct Streams {
  FileDescriptor input = createMemoryFile("input"), output = createMemoryFile("output"),
                 error = createMemoryFile("error");

  std::optional<ChildProcess> start(const std::vector<std::string>& command) const {
    return ChildProcess::start(command, {input, output, error});
  }
};

TEST(ChildProcess, HasItsOwnStreams) {
  const Streams streams;
  writeAll(streams.input, "what it reads", "input");
  lseek(streams.input.number(), 0, SEEK_SET);
  auto child = streams.start({"sh", "-c", "cat; echo \"$0\" >&2; exit 7", "a word"});
  ASSERT_TRUE(child);
  EXPECT_EQ(child->wait().status, 7);
  EXPECT_EQ(readAll(streams.output, "output"), "what it reads");
  EXPECT_EQ(readAll(streams.error, "error"), "a word\n");
}

TEST(ChildProcess, IsNoneWithoutItsProgram) {
  EXPECT_FALSE(Streams().start({"no-program-has-this-name"}));
}

TEST(ChildProcess, NamesTheSignalThatEndedIt) {
  const ProcessEnd end = Streams().start({"sh", "-c", "kill -9 $$"})->wait();
  EXPECT_EQ(end.signal, SIGKILL);
  EXPECT_EQ(end.status, 0);
}

TEST(ChildProcess, IsKilledWhereItLastsTooLong) {
  EXPECT_FALSE(ChildProcess::copy([] { pause(); }).wait(seconds(0)));
  EXPECT_TRUE(ChildProcess::copy([] {}).wait(seconds(60)));
}

TEST(ChildProcess, IsKilledWhereNobodyWaits) {
  Streams().start({"sleep", "60"});
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
}

TEST(ChildProcess, ThatIsACopyKeepsItsErrors) {
  EXPECT_EQ(ChildProcess::copy([] { throw 1; }).wait().status, 0);
  EXPECT_EQ(ChildProcess::copy([] { _exit(7); }).wait().status, 7);
}

}  // namespace
}  // namespace rotatebook::system
