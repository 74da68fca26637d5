// A render in which each call that changes a file fails, or ends the process, one after the other.
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <string>
#include <vector>

#include "cli/program_test.h"

namespace rotatebook::cli::testing {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;

constexpr int kKill = 0;
constexpr int kMostCalls = 400;  // A render of three frames has fewer.

/// What stands for a frame, a clip or a table, as opposed to what is on its way.
bool isFinal(const std::string& name) {
  return !name.ends_with('/') && name.find(".rotatebook-") == std::string::npos &&
         name.find("frames.") == std::string::npos &&
         name.find("/tiny.partial.") == std::string::npos;
}

bool isTemporary(const std::string& name) {
  return name.find(".rotatebook-") != std::string::npos;
}

class Faults : public ProgramTest {
 protected:
  Faults() { render("whole", {}); }

  ChildResult render(const std::string& folder, std::vector<std::string> options,
                     ChildSettings settings = {}) const {
    options.insert(options.begin(),
                   {"render", "tiny.toml", "--set", "clip.duration=0.05", "-o", folder});
    return run(options, std::move(settings));
  }

  /// A render in which the call of this number has the fault.
  ChildResult renderWithFault(const std::string& call, int number, int error,
                              std::vector<std::string> options) const {
    ChildSettings settings;
    settings.environment = {
        {"LD_PRELOAD", ROTATEBOOK_FAULTS},
        {"ROTATEBOOK_FAULT", call + ':' + std::to_string(number) + ':' + std::to_string(error)},
        {"ROTATEBOOK_FAULT_BELOW", (folder() / "out").string()}};
    return render("out", std::move(options), settings);
  }

  /// No file under a final name is half-written: each is that of a render without faults.
  void expectWhole(const std::string& during) const {
    for (const std::string& name : files()) {
      if (!name.starts_with("out/") || !isFinal(name)) continue;
      std::string wanted = "whole" + name.substr(3);
      const std::size_t partial = wanted.find("tiny.partial/");
      if (partial != std::string::npos) wanted.replace(partial, 13, "tiny/");
      EXPECT_TRUE(read(name) == read(wanted)) << name << " is half-written, " << during;
    }
  }

  /// Another render goes on, and all is as if nothing had happened.
  void expectResumed(const std::string& after) const {
    const ChildResult result = render("out", {"--resume"});
    EXPECT_EQ(result.status, 0) << result.error << after;
    std::vector<std::string> whole, resumed;
    for (const std::string& name : files()) {
      if (name.starts_with("whole/")) whole.push_back(name.substr(6));
      if (name.starts_with("out/")) resumed.push_back(name.substr(4));
    }
    EXPECT_EQ(whole, resumed) << after;
    for (const std::string& name : whole) {
      if (name.empty() || name.ends_with('/')) continue;
      EXPECT_TRUE(read("out/" + name) == read("whole/" + name)) << name << " differs, " << after;
    }
  }

  void removeOut() const { std::filesystem::remove_all(folder() / "out"); }
};

TEST_F(Faults, KillAtAnyChangeOfAFileLosesNothing) {
  int number = 1;
  for (; number < kMostCalls; ++number) {
    removeOut();
    const int status = renderWithFault("any", number, kKill, {}).status;
    if (status == 0) break;
    const std::string when = "killed at call " + std::to_string(number);
    ASSERT_EQ(status, 128 + SIGKILL) << when;
    expectWhole(when);
    expectResumed(when);
  }
  EXPECT_GT(number, 40) << "the faults don't reach the program";
  EXPECT_LT(number, kMostCalls);
}

TEST_F(Faults, FailureOfAnyChangeIsToldAndLosesNothing) {
  struct Case {
    const char* call;
    int error;
    const char* words;
  };
  for (const Case& fault :
       {Case{"write", ENOSPC, "No space left on device"}, Case{"flush", EIO, "Input/output error"},
        Case{"rename", EDQUOT, "Disk quota exceeded"}, Case{"open", EROFS, "Read-only file system"},
        Case{"mkdir", ENOSPC, "No space left on device"}}) {
    int number = 1;
    for (; number < kMostCalls; ++number) {
      removeOut();
      const ChildResult result = renderWithFault(fault.call, number, fault.error, {});
      if (result.status == 0) break;
      const std::string when = std::string(fault.call) + " fails at " + std::to_string(number);
      EXPECT_EQ(result.status, 3) << when << result.error;
      EXPECT_THAT(result.error, HasSubstr(fault.words)) << when;
      EXPECT_THAT(result.error, ContainsRegex("^rotatebook: can't [^\n]* out[^\n]*: ")) << when;
      EXPECT_FALSE(std::ranges::any_of(files(), isTemporary)) << when;
      expectWhole(when);
      expectResumed(when);
    }
    EXPECT_GT(number, 1) << fault.call << ": the faults don't reach the program";
    EXPECT_LT(number, kMostCalls);
  }
}

}  // namespace
}  // namespace rotatebook::cli::testing
