// A render in which a call that changes a file fails, or ends the process, one after the other:
// every third of them, or all if ROTATEBOOK_ALL_FAULTS is set.
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/same_bytes.h"
#include "cli/program_test.h"

namespace rotatebook::cli::testing {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::ContainsRegex;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr int kKill = 0, kCrash = -SIGSEGV;
constexpr long kNowhere = 1;    // No place of a request for memory.
constexpr int kMaxCalls = 400;  // A render of three frames has fewer.
constexpr long kNever = 1'000'000;

/// AddressSanitizer wants to be loaded before all others, as the faults do, some of which then are
/// of memory that it gave.
const std::pair<std::string, std::string> kSanitizerMayBeLater{
    "ASAN_OPTIONS", "verify_asan_link_order=0:alloc_dealloc_mismatch=0"};

/// Returns whether each call is to fail once, not only every third.
bool all() {
  return std::getenv("ROTATEBOOK_ALL_FAULTS") != nullptr;
}

int step() {
  return all() ? 1 : 3;
}

/// Returns whether it is the name of a frame, a clip or a table, as opposed to one on its way.
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

  /// For a run in which the call of this number has the fault.
  ChildSettings withFault(const std::string& call, long number, int error) const {
    ChildSettings settings;
    settings.environment = {
        {"LD_PRELOAD", ROTATEBOOK_FAULTS},
        kSanitizerMayBeLater,
        {"ROTATEBOOK_FAULT", call + ':' + std::to_string(number) + ':' + std::to_string(error)},
        {"ROTATEBOOK_FAULT_BELOW", (folder() / "out").string()},
        {"ROTATEBOOK_FAULT_COUNT", (folder() / "count").string()}};
    return settings;
  }

  ChildResult renderWithFault(const std::string& call, long number, int error,
                              std::vector<std::string> options) const {
    return render("out", std::move(options), withFault(call, number, error));
  }

  /// Returns the changes of files in out/ by a render without a fault, in order: calls and paths
  /// within the test's folder.
  std::vector<std::pair<std::string, std::string>> changesOfARender() const {
    removeOut();
    ChildSettings settings = withFault("any", kNever, kKill);
    settings.environment.emplace_back("ROTATEBOOK_FAULT_CHANGES", (folder() / "changes").string());
    const ChildResult result = render("out", {}, std::move(settings));
    EXPECT_EQ(result.status, 0) << result.error;
    std::istringstream lines(read("changes"));
    std::vector<std::pair<std::string, std::string>> changes;
    for (std::string call, path; lines >> call && std::getline(lines >> std::ws, path);) {
      changes.emplace_back(call, std::filesystem::relative(path, folder()).string());
    }
    return changes;
  }

  /// No file under a final name is half-written: each is that of a render without faults.
  void expectWhole(const std::string& during) const {
    for (const std::string& name : files()) {
      if (!name.starts_with("out/") || !isFinal(name)) continue;
      std::string wanted = "whole" + name.substr(3);
      const std::size_t partial = wanted.find("tiny.partial/");
      if (partial != std::string::npos) wanted.replace(partial, 13, "tiny/");
      EXPECT_TRUE(rotatebook::testing::sameBytes(read(name), read(wanted)))
          << name << " is half-written, " << during;
    }
  }

  /// Returns the places at which the last run with a fault of memory asked for some, in the order
  /// of the first requests.
  std::vector<long> countedPlaces() const {
    std::istringstream lines(read("count"));
    return {std::istream_iterator<long>(lines), {}};
  }

  /// It failed as it should, and left nothing half-written.
  void expectFailure(const ChildResult& result, const ::testing::Matcher<std::string>& message,
                     const std::string& when) const {
    EXPECT_EQ(result.status, 3) << when << result.error;
    EXPECT_THAT(result.error, message) << when;
    EXPECT_FALSE(std::ranges::any_of(files(), isTemporary)) << when;
    expectWhole(when);
  }

  /// Another render goes on, and all is as if nothing had happened.
  void expectResumed(const std::string& after) const {
    const ChildResult result = render("out", {"--resume"});
    EXPECT_EQ(result.status, 0) << result.error << after;
    expectSameFiles("whole", "out", after);
  }

  void removeOut() const { std::filesystem::remove_all(folder() / "out"); }
};

TEST_F(Faults, KillAtAnyChangeOfAFileLosesNothing) {
  int number = 1;
  for (; number < kMaxCalls; number += step()) {
    removeOut();
    const int status = renderWithFault("any", number, kKill, {}).status;
    if (status == 0) break;
    const std::string when = "killed at call " + std::to_string(number);
    ASSERT_EQ(status, 128 + SIGKILL) << when;
    expectWhole(when);
    expectResumed(when);
  }
  EXPECT_GT(number, 40) << "the faults don't reach the program";
  EXPECT_LT(number, kMaxCalls);
}

// So that a power cut leaves no file that is there and empty.
TEST_F(Faults, EveryFileIsOnTheDiskBeforeItGetsItsName) {
  std::map<std::string, std::string> last;  // call that changed a file
  int renamed = 0;
  for (const auto& [call, path] : changesOfARender()) {
    if (call == "rename" && isTemporary(path)) {
      EXPECT_EQ(last[path], "flush") << path;
      ++renamed;
    }
    last[path] = call;
  }
  EXPECT_GE(renamed, 6) << "three frames, clip, table and poster";
}

TEST_F(Faults, ARenderEndsWithItsFolderOnTheDisk) {
  bool flushed = false;
  int renamed = 0;
  for (const auto& [call, path] : changesOfARender()) {
    if (call == "rename") {
      flushed = false;
      ++renamed;
    }
    flushed = flushed || (call == "flush" && path == "out");
  }
  EXPECT_TRUE(flushed) << "after the last of " << renamed << " new names";
  EXPECT_GE(renamed, 6) << "three frames, clip, table and poster";
}

TEST_F(Faults, FramesFolderIsOnTheDiskBeforeItGetsItsName) {
  std::string last;  // change of a name in it
  bool moved = false;
  for (const auto& [call, path] : changesOfARender()) {
    if (call == "rename" && path.ends_with(".partial")) {
      EXPECT_EQ(last, "flush");
      moved = true;
    }
    const bool within = path.find(".partial/") != std::string::npos && call == "rename";
    if (within || path.ends_with(".partial")) last = call;
  }
  EXPECT_TRUE(moved);
}

TEST_F(Faults, FailureOfAnyChangeIsReportedAndLosesNothing) {
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
    for (; number < kMaxCalls; number += step()) {
      removeOut();
      const ChildResult result = renderWithFault(fault.call, number, fault.error, {});
      if (result.status == 0) break;
      const std::string when = std::string(fault.call) + " fails at " + std::to_string(number);
      expectFailure(
          result,
          AllOf(HasSubstr(fault.words), ContainsRegex("^rotatebook: can't [^\n]* out[^\n]*: ")),
          when);
      expectResumed(when);
    }
    EXPECT_GT(number, 1) << fault.call << ": the faults don't reach the program";
    EXPECT_LT(number, kMaxCalls);
  }
}

// Of a render that goes on after its video was removed.
TEST_F(Faults, FailureOfAnyReadIsReportedOrRepaired) {
  int failures = 0, number = 1;
  for (; number < kMaxCalls; number += step()) {
    removeOut();
    std::filesystem::copy(folder() / "whole", folder() / "out",
                          std::filesystem::copy_options::recursive);
    std::filesystem::remove(folder() / "out/tiny.mp4");
    const ChildResult result = renderWithFault("read", number, EIO, {"--resume"});
    if (std::stoi(read("count")) < number) break;
    const std::string when = "read " + std::to_string(number) + " fails";
    if (result.status == 0) {
      expectSameFiles("whole", "out", when);
      continue;
    }
    ++failures;
    expectFailure(result, ContainsRegex("rotatebook: [^\n]*: Input/output error"), when);
    expectResumed(when);
  }
  EXPECT_GT(failures, 2) << "the faults don't reach the program";
  EXPECT_LT(number, kMaxCalls);
}

TEST_F(Faults, FailureOfTheEncoderIsReportedAndLosesNothing) {
  int number = 1;
  for (; number < kMaxCalls; number += step()) {
    removeOut();
    const ChildResult result = renderWithFault("encode", number, EIO, {});
    if (result.status == 0) break;
    const std::string when = "encoding fails at " + std::to_string(number);
    expectFailure(result, ContainsRegex("^rotatebook: .*: Input/output error"), when);
    expectResumed(when);
  }
  EXPECT_GT(number, 10) << "the faults don't reach the program";
}

// A device that fails leaves others to try: a render may end well, then with the same pictures.
TEST_F(Faults, FailureOfGraphicsIsReported) {
  int failures = 0;
  for (int number = 1; number < 40; number += step()) {
    removeOut();
    const ChildResult result = renderWithFault("graphics", number, EIO, {});
    const std::string when = "graphics fail at " + std::to_string(number);
    if (result.status == 0) {
      EXPECT_TRUE(rotatebook::testing::sameBytes(read("out/tiny/frame_00001.png"),
                                                 read("whole/tiny/frame_00001.png")))
          << when;
      continue;
    }
    ++failures;
    expectFailure(result, HasSubstr("rotatebook: "), when);
    expectResumed(when);
  }
  EXPECT_GT(failures, 2) << "the faults don't reach the program";
}

// The driver crashes at the same call of the process that explains the crash, if that comes to it.
// Sanitizers say it in their own words.
TEST_F(Faults, CrashOfADriverIsReportedAndLosesNothing) {
  int crashes = 0;
  for (int number = 1; number < 40; number += 2 * step()) {
    removeOut();
    const ChildResult result = renderWithFault("graphics", number, kCrash, {});
    if (result.status == 0) break;
    const std::string when = "graphics crash at " + std::to_string(number);
    EXPECT_THAT(result.status, AnyOf(3, 128 + SIGSEGV, 1)) << when;
    EXPECT_THAT(result.error,
                ContainsRegex("can't draw: .*: its driver: ends the process .*remedy: |"
                              "rotatebook: crashed, |Sanitizer"))
        << when;
    expectWhole(when);
    expectResumed(when);
    ++crashes;
  }
  EXPECT_GT(crashes, 2) << "the faults don't reach the program";
}

TEST_F(Faults, DoctorOutlivesDriversThatCrash) {
  const ChildResult result = run({"doctor"}, withFault("graphics", 1, kCrash));
  EXPECT_EQ(result.status, 3);
  EXPECT_THAT(result.error, IsEmpty());
  EXPECT_THAT(
      result.output,
      AllOf(ContainsRegex("its driver: ends the process \\((Segmentation fault|exit status 1)\\)"),
            ContainsRegex("\n  1. EGL device 0[^\n]*: its driver: ends the process"),
            HasSubstr("\n     remedy: update "),
            EndsWith("\nNOT READY to render: nothing draws as it should.\n")));
}

// Each place, told by the calls that lead there, at which a render asks for memory.
TEST_F(Faults, FailureOfAnyRequestForMemoryIsReported) {
  renderWithFault("memory", kNowhere, ENOMEM, {});
  const std::vector<long> places = countedPlaces();
  ASSERT_GT(places.size(), 500U) << "the faults don't reach the program";
  int failures = 0;
  for (std::size_t i = 0; i < places.size(); i += all() ? 1 : 50) {
    removeOut();
    const ChildResult result = renderWithFault("memory", places[i], ENOMEM, {});
    const std::string when =
        "request at place " + std::to_string(i) + ", " + std::to_string(places[i]) + ", fails";
    if (result.status == 0) {
      // Threads don't ask at the same places in each run.
      EXPECT_THAT(countedPlaces(), Not(Contains(places[i]))) << when << ", and nobody is told";
      continue;
    }
    ++failures;
    EXPECT_EQ(result.status, 3) << when << result.error;
    EXPECT_THAT(result.error, HasSubstr("rotatebook: ")) << when;
    expectWhole(when);
    // The process ends without cleaning up where no exception may pass.
    if (std::ranges::any_of(files(), isTemporary)) expectResumed(when);
  }
  EXPECT_GT(failures, 10) << "the faults don't reach the program";
}

}  // namespace
}  // namespace rotatebook::cli::testing
