// Pages for the web and plans in which a call that changes a file fails, or ends the process: every
// third of them, or all if ROTATEBOOK_ALL_FAULTS is set.
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/program_test.h"

namespace rotatebook::cli::testing {
namespace {

namespace fs = std::filesystem;

constexpr int kKilled = 0;
constexpr int kMaxChanges = 300;  // Packing a clip makes 60 and fewer.

class OtherFaults : public ProgramTest {
 protected:
  /// Runs a command in which a call that changes a file below out/ fails, or kills the process.
  ChildResult runWithFault(const std::vector<std::string>& command, int number, int error) const {
    // A failure to remove what is stale is none
    const std::string call = error == kKilled ? "any" : "write";
    ChildSettings settings;
    settings.environment = {
        {"LD_PRELOAD", ROTATEBOOK_FAULTS},
        {"ASAN_OPTIONS", "verify_asan_link_order=0:alloc_dealloc_mismatch=0"},
        {"ROTATEBOOK_FAULT", call + ":" + std::to_string(number) + ':' + std::to_string(error)},
        {"ROTATEBOOK_FAULT_BELOW", (folder() / "out").string()}};
    return run(command, settings);
  }

  /// Expects of `command`, which writes to out/, that whatever stops it, files under final names
  /// are those in whole/, and that the same command then makes all of them.
  void expectGoesOn(const std::vector<std::string>& command, int error, int leastChanges) const {
    const int step = std::getenv("ROTATEBOOK_ALL_FAULTS") != nullptr ? 1 : 3;
    int number = 1;
    for (; number < kMaxChanges; number += step) {
      fs::remove_all(folder() / "out");
      fs::create_directories(folder() / "out");
      const int status = runWithFault(command, number, error).status;
      if (status == 0) break;
      const std::string when = "stopped at call " + std::to_string(number);
      ASSERT_EQ(status, error == kKilled ? 128 + SIGKILL : 3) << when;
      expectWhole(when);
      const ChildResult again = run(command);
      EXPECT_EQ(again.status, 0) << when << again.error;
      expectSameFiles("whole", "out", when);
    }
    EXPECT_GT(number, leastChanges) << "the faults don't reach the program";
    EXPECT_LT(number, kMaxChanges);
  }

 private:
  /// Of the mark, which changes as files are written, and of a folder that is put together on the
  /// way, there is nothing to compare.
  void expectWhole(const std::string& when) const {
    for (const std::string& name : files()) {
      const bool isFinal = name.starts_with("out/") && !name.ends_with('/') &&
                           name.find("rotatebook-") == std::string::npos &&
                           !name.ends_with("/rotatebook.pack");
      if (!isFinal) continue;
      EXPECT_TRUE(read(name) == read("whole" + name.substr(3))) << name << when;
    }
  }
};

class PackFaults : public OtherFaults {
 protected:
  PackFaults() {
    run({"render", "tiny.toml", "-o", "results", "--no-png", "--set", "clip.duration=0.05"});
  }

  static std::vector<std::string> packInto(const std::string& target) {
    return {"page",  "tiny.toml",          "-o",     "results", "--no-thumbnails",
            "--set", "clip.duration=0.05", "--pack", target};
  }

  void expectGoesOn(const std::string& target, int error) const {
    fs::create_directories(folder() / "whole");
    ASSERT_EQ(run(packInto("whole/" + target)).status, 0);
    OtherFaults::expectGoesOn(packInto("out/" + target), error, error == kKilled ? 20 : 4);
  }
};

TEST_F(PackFaults, OfAFolderThatIsKilledLoseNothing) {
  expectGoesOn("site", kKilled);
}

TEST_F(PackFaults, OfAnArchiveThatIsKilledLoseNothing) {
  expectGoesOn("site.zip", kKilled);
}

TEST_F(PackFaults, OfAFullDiskLoseNothing) {
  expectGoesOn("site", ENOSPC);
}

TEST_F(PackFaults, OfAFullDiskLoseNoArchive) {
  expectGoesOn("site.zip", ENOSPC);
}

TEST_F(OtherFaults, OfAPlanThatIsKilledAreRepaired) {
  const auto submit = [](const std::string& folder) {
    return std::vector<std::string>{"submit", "render", "tiny.toml", "-o", folder,
                                    "--plan", "list",   "--chunk",   "5"};
  };
  // Plans name their folder
  ASSERT_EQ(run(submit("out")).status, 0);
  fs::rename(folder() / "out", folder() / "whole");
  expectGoesOn(submit("out"), kKilled, 8);
  expectGoesOn(submit("out"), ENOSPC, 2);
}

}  // namespace
}  // namespace rotatebook::cli::testing
