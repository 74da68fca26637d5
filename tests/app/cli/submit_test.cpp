// `rotatebook submit` and `status`, without a cluster; and what they ask of other commands.
#include <string>
#include <vector>

#include "cli/program_test.h"

namespace rotatebook::cli::testing {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

class Submit : public ProgramTest {
 protected:
  void expectRefused(const std::vector<std::string>& arguments, const std::string& message,
                     int status = 2) const {
    const ChildResult result = run(arguments);
    EXPECT_EQ(result.status, status) << result.output;
    EXPECT_THAT(result.error, HasSubstr(message));
    EXPECT_THAT(files(), IsEmpty()) << "nothing is written";
  }

  /// Runs each line in a shell; returns the statuses.
  std::vector<int> runLines(const std::string& text) const {
    std::vector<int> statuses;
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = text.find('\n', begin);
      const std::string line = text.substr(begin, end - begin);
      if (!line.starts_with('#')) {
        statuses.push_back(WEXITSTATUS(std::system((line + " >/dev/null").c_str())));
      }
      begin = end + 1;
    }
    return statuses;
  }
};

TEST_F(Submit, PrintsCommandsThatMakeTheClip) {
  const ChildResult plan =
      run({"submit", "render", "tiny.toml", "-o", "many", "--chunk", "5", "--plan", "list"});
  ASSERT_EQ(plan.status, 0) << plan.error;
  EXPECT_THAT(plan.output, AllOf(HasSubstr("--part 3/3"), HasSubstr("--format mp4")));
  EXPECT_THAT(runLines(plan.output), ElementsAre(0, 0, 0, 0));
  for (const char* format : {"list", "parallel"}) {
    const ChildResult again =
        run({"submit", "render", "tiny.toml", "-o", "many", "--chunk", "5", "--plan", format});
    EXPECT_EQ(again.output, "");
    EXPECT_EQ(again.error, "nothing is missing\n");
  }
  EXPECT_EQ(run({"render", "tiny.toml", "-o", "one"}).status, 0);
  EXPECT_TRUE(has("many/farm/render/plan.json"));
  std::filesystem::remove_all(folder() / "many/farm");
  EXPECT_GT(expectSameFiles("many", "one"), 14);
}

TEST_F(Submit, GivesATaskSeveralShortClipsAndJoinsNothing) {
  for (const char* name : {"b.toml", "c.toml"}) write(name, kTiny);
  const std::vector<std::string> submit{"submit", "render",   "tiny.toml", "b.toml", "c.toml",
                                        "-o",     "many",     "--chunk",   "24",     "--plan",
                                        "list",   "--no-png", "--format",  "mp4,gif"};
  const std::string plan = run(submit).output;
  EXPECT_THAT(plan, AllOf(Not(HasSubstr("--part")), Not(HasSubstr("# Once"))));
  const std::size_t second = plan.find('\n') + 1;
  EXPECT_THAT(runLines(plan.substr(0, second)), ElementsAre(0));
  EXPECT_TRUE(has("many/tiny.mp4") && has("many/b.gif"));
  EXPECT_FALSE(has("many/c.mp4") || has("many/tiny/frame_00000.png"));
  EXPECT_THAT(run({"status", "many"}).output,
              AllOf(HasSubstr("done: 1 of 2 tasks"), HasSubstr("waiting: 1 task")));
  EXPECT_EQ(run(submit).output, plan.substr(second)) << "the rest";
  EXPECT_THAT(runLines(plan.substr(second)), ElementsAre(0));
  EXPECT_THAT(run({"status", "many"}).output, HasSubstr("render of c: done\n"));
  EXPECT_EQ(run({"render", "tiny.toml", "b.toml", "c.toml", "-o", "one", "--no-png", "--format",
                 "mp4,gif"})
                .status,
            0);
  std::filesystem::remove_all(folder() / "many/farm");
  EXPECT_GT(expectSameFiles("many", "one"), 14);
}

TEST_F(Submit, CutsLongClipsAndKeepsShortOnesWholeInOnePlan) {
  for (const char* name : {"b.toml", "long.toml"}) write(name, kTiny);
  write("long.toml", std::string(kTiny) + "fps = 200\n");
  const std::string plan = run({"submit", "render", "tiny.toml", "long.toml", "b.toml", "-o",
                                "many", "--chunk", "24", "--plan", "list"})
                               .output;
  EXPECT_THAT(plan, AllOf(HasSubstr("long.toml --part 2/2"), HasSubstr("b.toml --resume")));
  EXPECT_THAT(runLines(plan), ElementsAre(0, 0, 0, 0)) << "short ones, two parts, the join";
  EXPECT_THAT(run({"status", "many"}).output, HasSubstr("done: 3 of 3 tasks"));
  EXPECT_EQ(run({"render", "tiny.toml", "long.toml", "b.toml", "-o", "one"}).status, 0);
  std::filesystem::remove_all(folder() / "many/farm");
  EXPECT_GT(expectSameFiles("many", "one"), 70);
}

TEST_F(Submit, PrintsOnlyWhatIsMissing) {
  const std::vector<std::string> submit{"submit", "render", "tiny.toml", "-o", "many",
                                        "--plan", "list",   "--chunk",   "5"};
  run(submit);
  EXPECT_EQ(run({"render", "tiny.toml", "-o", "many", "--part", "2/3"}).status, 0);
  EXPECT_THAT(run(submit).output, AllOf(HasSubstr("--part 1/3"), Not(HasSubstr("--part 2/3"))));
  const ChildResult status = run({"status", "many"});
  EXPECT_EQ(status.status, 0) << status.error;
  EXPECT_THAT(status.output, AllOf(StartsWith("render of tiny: 4 of 12 frames are there\n"),
                                   HasSubstr("done: 1 of 3 tasks"), HasSubstr("waiting: 2 tasks")));
}

TEST_F(Submit, WritesNothingForADryRun) {
  const ChildResult plan =
      run({"submit", "render", "tiny.toml", "--chunk", "5", "--plan", "parallel", "--dry-run"});
  EXPECT_EQ(plan.status, 0) << plan.error;
  EXPECT_THAT(plan.output, StartsWith("#!/bin/sh\n"));
  EXPECT_THAT(files(), IsEmpty());
}

TEST_F(Submit, PassesOptionsOn) {
  const ChildResult plan = run({"submit", "render", "tiny.toml", "--set", "clip.duration=0.1",
                                "--size", "32x18", "--format", "gif", "--device", "software",
                                "--cores", "2", "--chunk", "3", "--plan", "list", "--dry-run"});
  EXPECT_THAT(plan.output,
              AllOf(StartsWith("LP_NUM_THREADS=2 "), HasSubstr("--part 2/2"),
                    HasSubstr("--set clip.duration=0.1 --size 32x18 --device software\n"),
                    HasSubstr("--device software --format gif\n")));
}

TEST_F(Submit, RefusesWhatItCannotSend) {
  expectRefused({"submit", "draw", "tiny.toml", "--slurm"}, "\"draw\": unknown work");
  expectRefused({"submit", "render", "tiny.toml"}, "submit to what?");
  expectRefused({"submit", "render", "tiny.toml", "--slurm", "--plan", "list"}, "exclude");
  expectRefused({"submit", "render", "tiny.toml", "--plan", "lists"}, "did you mean \"list\"");
  expectRefused({"submit", "map", "tiny.toml", "--plan", "list"}, "has no [map]");
  expectRefused({"submit", "render", "tiny.toml", "--plan", "list", "--set", "clip.fps=0"},
                "clip.fps");
  expectRefused({"status", "elsewhere"}, "holds no plan");
}

TEST_F(Submit, RefusesOptionsWithoutEffect) {
  expectRefused({"submit", "render", "tiny.toml", "--plan", "list", "--partition", "cpu"},
                "--partition requires --slurm");
  expectRefused({"submit", "render", "tiny.toml", "--plan", "list", "--sbatch=--qos=low"},
                "--sbatch requires --slurm");
  expectRefused({"submit", "map", "tiny.toml", "--plan", "list", "--format", "gif"},
                "--format is for submit render");
  expectRefused({"submit", "study", "tiny.toml", "--plan", "list", "--device", "0"},
                "--device is for submit render");
  expectRefused({"submit", "study", "tiny.toml", "--plan", "list", "--chunk", "3"},
                "a study is one task");
}

TEST_F(Submit, SaysThatThereIsNoCluster) {
  ChildSettings settings;
  settings.environment = {{"PATH", "/nonexistent"}};
  const ChildResult result = run({"submit", "render", "tiny.toml", "--slurm"}, settings);
  EXPECT_EQ(result.status, 3);
  EXPECT_THAT(result.error, AllOf(HasSubstr("there is no scontrol here"), HasSubstr("--plan")));
  EXPECT_THAT(files(), IsEmpty());
}

TEST_F(Submit, NeedsAChunkWhereItCannotMeasure) {
  const std::vector<std::string> submit{"submit", "render", "tiny.toml",
                                        "--plan", "list",   "--dry-run"};
  const ChildResult result = runWithoutGraphics(submit);
  EXPECT_EQ(result.status, 3);
  EXPECT_THAT(result.error, AllOf(HasSubstr("can't measure"), HasSubstr("--chunk")));
  EXPECT_EQ(run(submit).status, 0);
}

TEST_F(Submit, ScenesThatChangedSinceAreRefused) {
  const std::vector<std::string> submit{"submit", "render", "tiny.toml", "-o", "many",
                                        "--plan", "list",   "--chunk",   "6"};
  const std::string lines = run(submit).output;
  const std::string first = lines.substr(0, lines.find('\n') + 1);
  write("tiny.toml", std::string(kTiny) + "fps = 30\n");
  EXPECT_THAT(runLines(first), ElementsAre(2)) << "by the task";
  EXPECT_FALSE(has("many/tiny"));
  write("tiny.toml", kTiny);
  EXPECT_THAT(runLines(first), ElementsAre(0));
  write("tiny.toml", std::string(kTiny) + "fps = 30\n");
  const ChildResult again = run(submit);
  EXPECT_EQ(again.status, 2) << "by submit, once there are frames";
  EXPECT_THAT(again.error, HasSubstr("holds frames of other settings"));
}

const std::vector<std::string> kFive{"submit", "render", "tiny.toml", "-o", "many",
                                     "--plan", "list",   "--chunk",   "5"};

TEST_F(Submit, RepairsCommandsThatAreLostOrWereChanged) {
  ASSERT_EQ(run(kFive).status, 0);
  for (const char* name : {"many/farm/render/tasks.txt", "many/farm/render/join.txt"}) {
    const std::string commands = read(name);
    std::filesystem::remove(folder() / name);
    ASSERT_EQ(run(kFive).status, 0);
    EXPECT_EQ(read(name), commands) << "lost";
    write(name, "rm -rf /\n");
    ASSERT_EQ(run(kFive).status, 0);
    EXPECT_EQ(read(name), commands) << "changed";
  }
}

TEST_F(Submit, RemovesNothingThroughALink) {
  for (const std::string name : {"log/1.txt", "ends/1"}) {
    const std::string linked = name.substr(0, name.find('/'));
    const std::string left = "precious" + name.substr(linked.size());
    write("precious/notes.txt", "mine");
    write(left, "mine");
    write("many/farm/render/x", "");
    std::filesystem::create_directory_symlink(folder() / "precious",
                                              folder() / "many/farm/render" / linked);
    const ChildResult refused = run(kFive);
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.error, HasSubstr(name + " is of no plan that is known here"));
    std::filesystem::remove(folder() / left);
    EXPECT_EQ(run(kFive).status, 0) << "they may lie on another disk";

    // A new plan would remove what the tasks of this one left
    write(left, "0 n1 3\n");
    std::vector<std::string> other = kFive;
    other.back() = "3";
    const ChildResult again = run(other);
    EXPECT_EQ(again.status, 2) << name;
    EXPECT_THAT(again.error, HasSubstr(linked + ", through which nothing is removed"));
    EXPECT_EQ(read(left), "0 n1 3\n");
    EXPECT_EQ(read("precious/notes.txt"), "mine");
    std::filesystem::remove_all(folder() / "many");
    std::filesystem::remove_all(folder() / "precious");
  }
}

TEST_F(Submit, KeepsFilesThatNoTaskLeft) {
  ASSERT_EQ(run(kFive).status, 0);
  write("many/farm/render/log/notes.txt", "mine");
  write("many/farm/render/log/2024.txt", "mine");
  write("many/farm/render/log/1.txt", "printed");
  write("many/farm/render/ends/1", "0 n1 3\n");
  write("many/farm/render/ends/.2.4711", "0 n1");
  std::vector<std::string> other = kFive;
  other.back() = "3";
  ASSERT_EQ(run(other).status, 0);
  EXPECT_THAT(
      files(),
      AllOf(Contains("many/farm/render/log/notes.txt"), Contains("many/farm/render/log/2024.txt"),
            Not(Contains("many/farm/render/log/1.txt")), Not(Contains("many/farm/render/ends/1")),
            Not(Contains("many/farm/render/ends/.2.4711"))));
}

TEST_F(Submit, ReplacesNoFileThatNoPlanLeft) {
  for (const char* name : {"tasks.txt", "join.txt", "part.sh", "log/2.txt", "ends/join"}) {
    const std::string file = std::string("many/farm/render/") + name;
    write(file, kTiny);
    const ChildResult result = run(kFive);
    EXPECT_EQ(result.status, 2) << name;
    EXPECT_THAT(result.error, HasSubstr(name + std::string(" is of no plan that is known here")));
    EXPECT_EQ(read(file), kTiny);
    std::filesystem::remove_all(folder() / "many");
  }
}

TEST_F(Submit, IsNotMadeOfItsOwnFiles) {
  const std::string file = "many/farm/render/tasks.txt";
  write(file, kTiny);
  const ChildResult result =
      run({"submit", "render", file, "-o", "many", "--plan", "list", "--chunk", "5"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.error, HasSubstr(file + " is the scene itself and would be replaced"));
  EXPECT_EQ(read(file), kTiny);
}

}  // namespace
}  // namespace rotatebook::cli::testing
