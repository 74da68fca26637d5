// Parts of a clip that several machines draw at the same time into one folder.
#include <chrono>
#include <filesystem>
#include <fstream>
#include <future>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cli/program_test.h"
#include "lacking.h"

namespace rotatebook::cli::testing {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

using Environment = std::vector<std::pair<std::string, std::string>>;

/// A process on one of several machines.
struct Task {
  std::vector<std::string> options;
  Environment environment{};
};

class Farm : public ProgramTest {
 protected:
  std::future<ChildResult> start(const Task& one) const {
    return std::async(std::launch::async, [this, one] {
      std::vector<std::string> arguments{"render", "tiny.toml", "--device", "software"};
      arguments.insert(arguments.end(), one.options.begin(), one.options.end());
      ChildSettings settings;
      settings.environment = one.environment;
      settings.timeout = std::chrono::seconds(300);
      return run(arguments, settings);
    });
  }

  std::vector<ChildResult> runAtOnce(const std::vector<Task>& all) const {
    std::vector<std::future<ChildResult>> started;
    started.reserve(all.size());
    for (const Task& one : all) started.push_back(start(one));
    std::vector<ChildResult> results;
    for (std::future<ChildResult>& result : started) results.push_back(result.get());
    return results;
  }

  /// As a machine of its own: locks are `locks`, the start is that of the machine `number`, and all
  /// processes have the same number.
  Environment machine(const std::string& locks, int number) const {
    const std::string file = "start-" + std::to_string(number);
    write(file, std::to_string(number));
    return {{"LD_PRELOAD", ROTATEBOOK_FAULTS},
            {"ASAN_OPTIONS", "verify_asan_link_order=0:alloc_dealloc_mismatch=0"},
            {"ROTATEBOOK_FAULT_LOCKS", locks},
            {"ROTATEBOOK_FAULT_START", (folder() / file).string()},
            {"ROTATEBOOK_FAULT_PROCESS", "4321"}};
  }

  /// Draws four parts at the same time, each with its `environments`, joins them, and expects the
  /// files of a single render.
  void expectPartsToJoin(const std::vector<Environment>& environments) const {
    const std::vector<std::string> length{"--set", "clip.duration=2"};
    std::vector<Task> parts;
    for (std::size_t i = 0; i < environments.size(); ++i) {
      const std::string part = std::to_string(i + 1) + '/' + std::to_string(environments.size());
      parts.push_back({{length[0], length[1], "-o", "parts", "--part", part}, environments[i]});
    }
    for (const ChildResult& part : runAtOnce(parts)) EXPECT_EQ(part.status, 0) << part.error;
    for (const std::string& name : files()) {
      EXPECT_THAT(name, AnyOf(Not(HasSubstr(".rotatebook-")), HasSubstr(".rotatebook-0")));
    }
    const std::vector<ChildResult> wholes =
        runAtOnce({{{length[0], length[1], "-o", "parts", "--resume"}},
                   {{length[0], length[1], "-o", "whole"}}});
    for (const ChildResult& whole : wholes) EXPECT_EQ(whole.status, 0) << whole.error;
    EXPECT_THAT(wholes[0].output, HasSubstr("kept 120 frames of an earlier run"));
    for (const std::string& name : files()) {
      if (name.ends_with(".rotatebook-0")) std::filesystem::remove(folder() / name);
    }
    EXPECT_GT(expectSameFiles("whole", "parts"), 120);
  }

  /// Draws two parts of different settings, which write their manifests at the same time, and
  /// expects that one is drawn and the other refused.
  std::vector<ChildResult> beginTogether(int round) const {
    const std::string meeting = (folder() / ("meeting-" + std::to_string(round))).string();
    std::filesystem::create_directory(meeting);
    Environment one = machine("unseen", 1), other = machine("unseen", 2);
    one.emplace_back("ROTATEBOOK_FAULT_MEETING", meeting);
    other.emplace_back("ROTATEBOOK_FAULT_MEETING", meeting);
    const std::vector<ChildResult> results = runAtOnce(
        {{{"--part", "1/2"}, one}, {{"--part", "2/2", "--set", "book.color='#203040'"}, other}});
    EXPECT_TRUE(std::filesystem::exists(meeting + "/second")) << "they didn't meet";
    const std::multiset<int> statuses{results[0].status, results[1].status};
    EXPECT_THAT(statuses, ElementsAre(0, 2)) << results[0].error << results[1].error;
    EXPECT_THAT(results[results[0].status == 0 ? 1 : 0].error,
                AnyOf(HasSubstr("out/tiny awaits the frames of a part that began with other "
                                "settings: "),
                      HasSubstr("out/tiny holds frames with other settings: ")));
    return results;
  }
};

TEST_F(Farm, PartsJoinWhereMachinesDontSeeEachOthersLocks) {
  std::vector<Environment> machines;
  for (int i = 0; i < 4; ++i) machines.push_back(machine("unseen", i));
  expectPartsToJoin(machines);
}

TEST_F(Farm, PartsJoinWhereThereAreNoLocks) {
  std::vector<Environment> machines;
  for (int i = 0; i < 4; ++i) machines.push_back(machine("none", i));
  expectPartsToJoin(machines);
}

TEST_F(Farm, PartsOnOneMachineJoinWithoutLocks) {
  for (const std::string locks : {"unseen", "none"}) {
    Environment one = machine(locks, 1);
    one.pop_back();  // Numbers of processes differ.
    expectPartsToJoin({one, one, one, one});
    std::filesystem::remove_all(folder() / "parts");
    std::filesystem::remove_all(folder() / "whole");
  }
}

// Each has found no manifest when both write theirs.
TEST_F(Farm, OneOfPartsOfOtherSettingsThatBeginTogetherIsRefused) {
  int firstWon = 0;
  for (int round = 0; round < 20; ++round) {
    const std::vector<ChildResult> results = beginTogether(round);
    const bool firstWins = results[0].status == 0;
    firstWon += firstWins ? 1 : 0;
    EXPECT_TRUE(has(firstWins ? "out/tiny/frame_00000.png" : "out/tiny/frame_00006.png"));
    EXPECT_FALSE(has(firstWins ? "out/tiny/frame_00006.png" : "out/tiny/frame_00000.png"));
    std::filesystem::remove_all(folder() / "out");
  }
  RecordProperty("first_won", firstWon);
}

// Where a clip without PNGs was finished, there is a manifest already.
TEST_F(Farm, OneOfPartsThatTakeAFoldersPlaceTogetherIsRefused) {
  const ChildResult earlier = start({{"--no-png", "--set", "body.mass=2", "-o", "made"}}).get();
  ASSERT_EQ(earlier.status, 0) << earlier.error;
  for (int round = 0; round < 5; ++round) {
    std::filesystem::copy(folder() / "made", folder() / "out",
                          std::filesystem::copy_options::recursive);
    beginTogether(round);
    std::filesystem::remove_all(folder() / "out");
  }
}

/// Says what this machine lacks to draw other pixels under the same name; empty if nothing.
std::string whyNoOtherPixels() {
  std::ifstream stream("/proc/cpuinfo");
  const std::string facts{std::istreambuf_iterator<char>(stream), {}};
  return facts.find(" avx2 ") == std::string::npos ? "needs a processor with AVX2" : "";
}

TEST_F(Farm, PartsOfRenderersOfOneNameThatDrawOtherPixelsAreRefused) {
  ROTATEBOOK_SKIP_IF_LACKING(whyNoOtherPixels());
  // Both are "llvmpipe (LLVM 15.0.6, 128 bits)"; the second does without FMA.
  const Environment one{{"LP_NATIVE_VECTOR_WIDTH", "128"}};
  const Environment other{{"GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1"}};
  const ChildResult first = start({{"--part", "1/3"}, one}).get();
  EXPECT_EQ(first.status, 0) << first.error;
  const ChildResult same = start({{"--part", "2/3"}, one}).get();
  EXPECT_EQ(same.status, 0) << same.error;
  const ChildResult refused = start({{"--part", "3/3"}, other}).get();
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.error, AllOf(HasSubstr("holds frames with other settings: test frame is "),
                                   Not(HasSubstr("renderer is"))));
}

}  // namespace
}  // namespace rotatebook::cli::testing
