#include "farm/job_script.h"

#include <cstdlib>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "farm/fake_slurm.h"
#include "farm/plan_folder.h"

namespace rotatebook::farm {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using testing::emptyFolder;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::planOfClips;
using testing::textIn;

/// Runs the script of task 1, whose command is `command`, after `restarts` others; returns the
/// exit status.
int statusOf(const std::string& command, int restarts, const fs::path& folder) {
  const Plan plan = planOfClips(folder, {"a"});
  const PlanFiles files = planFiles(folder, plan.work);
  writeNewPlan(files, {plan});
  std::ofstream(files.tasks) << command << '\n';
  std::ofstream(files.partScript) << jobScript(plan, files, {1}, {}, true);
  const std::string line =
      "SLURM_ARRAY_TASK_ID=1 SLURMD_NODENAME=n7 SLURM_RESTART_COUNT=" + std::to_string(restarts) +
      " bash '" + files.partScript.string() + "'";
  const int status = std::system(line.c_str());
  return WEXITSTATUS(status);
}

TEST(JobScript, ListsTasksAsRanges) {
  EXPECT_EQ(rangesText({1, 2, 3, 5, 8, 9}), "1-3,5,8-9");
  EXPECT_EQ(rangesText({4}), "4");
}

TEST(JobScript, PassesTheUsersOptionsOn) {
  const Plan plan = planOfClips("/out", {"a"});
  const JobOptions options{"cpu", "lab", "1:00:00", "zen4", {"--qos=low", "--comment=a b"}};
  const std::string text = jobScript(plan, planFiles("/out", plan.work), {1, 2, 4}, options, true);
  for (const char* line :
       {"#SBATCH --array=1-2,4\n", "#SBATCH --requeue\n", "#SBATCH --open-mode=append\n",
        "#SBATCH --partition=cpu\n", "#SBATCH --account=lab\n", "#SBATCH --time=1:00:00\n",
        "#SBATCH --constraint=zen4\n", "#SBATCH --qos=low\n", "#SBATCH --comment=\"a b\"\n",
        "#SBATCH --output=/out/farm/render/log/%a.txt\n"})
    EXPECT_THAT(text, HasSubstr(line));
  const std::string join = jobScript(plan, planFiles("/out", plan.work), {}, {}, true);
  EXPECT_THAT(join, AllOf(HasSubstr("/log/join.txt"), Not(HasSubstr("--array"))));
}

TEST(JobScript, TakesPathsAsTheyAre) {
  const Plan plan = planOfClips("/my out/100%", {"a"});
  const std::string text = jobScript(plan, planFiles(plan.folder, plan.work), {1}, {}, true);
  EXPECT_THAT(text, HasSubstr("#SBATCH --output=\"/my out/100%%/farm/render/log/%a.txt\"\n"));
  EXPECT_THAT(text, HasSubstr("farm='/my out/100%/farm/render'\n"));
  const Plan odd = planOfClips("/it's#1\\2", {"a"});
  EXPECT_THAT(jobScript(odd, planFiles(odd.folder, odd.work), {1}, {}, true),
              HasSubstr("#SBATCH --chdir=\"/it's#1\\\\2\"\n"));
  for (const char* other : {"foo", "--array=1-3", "-d afterok:1", "--wrap=true", "-c4"}) {
    const JobOptions own{.others = {other}};
    EXPECT_THROW(jobScript(plan, planFiles("/out", plan.work), {1}, own, true), InputError)
        << other;
  }
  const JobOptions quoted{.others = {"--comment=\"x\""}};
  EXPECT_THROW(jobScript(plan, planFiles("/out", plan.work), {1}, quoted, true), InputError);
}

// sbatch takes the beginning of a name, and several letters after one hyphen.
TEST(JobScript, TakesNoneOfItsOwnOptionsInAnyWriting) {
  const Plan plan = planOfClips("/out", {"a"});
  const auto refuses = [&](const std::string& other) {
    const JobOptions options{.others = {other}};
    try {
      jobScript(plan, planFiles("/out", plan.work), {1}, options, true);
    } catch (const InputError&) {
      return true;
    }
    return false;
  };
  for (const char* other : {"--arra=0-3",
                            "--arr=0-3",
                            "--wra=true",
                            "--w=true",
                            "--outp=x",
                            "--op=truncate",
                            "--dep=x",
                            "--chd=/",
                            "--ntask=2",
                            "--cpus=3",
                            "--req",
                            "--no-req",
                            "--pars",
                            "-Ha0-3",
                            "-sD/",
                            "-Qn2",
                            "-a=0-3",
                            "--exclusive --wrap=x",
                            "--exclusive --wrap x",
                            "--hold -a 0-3",
                            "-H -a0-3",
                            "--",
                            "--=x"})
    EXPECT_TRUE(refuses(other)) << other;
  for (const char* other : {"--qos=low", "--ntasks-per-node=1", "--wait-all-nodes=1", "--exclusive",
                            "-qlow", "-H", "-wnode1", "--mem=4G", "--comment=a --wrap b"})
    EXPECT_FALSE(refuses(other)) << other;
  const JobOptions words{.others = {"--export=NONE --wrap=x"}};
  EXPECT_THAT(jobScript(plan, planFiles("/out", plan.work), {1}, words, true),
              HasSubstr("#SBATCH --export=\"NONE --wrap=x\"\n"));
}

TEST(JobScript, RefusesAnEmptyCommand) {
  const fs::path folder = emptyFolder();
  EXPECT_EQ(statusOf("", 0, folder), 2);
  EXPECT_THAT(textIn(folder / "farm/render/ends/1"), ::testing::StartsWith("2 n7 "));
}

TEST(JobScript, IsTriedAgainByWhatTheClusterHas) {
  const Plan plan = planOfClips("/out", {"a"});
  const PlanFiles files = planFiles("/out", plan.work);
  EXPECT_THAT(jobScript(plan, files, {1}, {}, true),
              AllOf(HasSubstr("exit 75"), Not(HasSubstr("scontrol"))));
  EXPECT_THAT(jobScript(plan, files, {1}, {}, false),
              AllOf(HasSubstr("scontrol requeue"), Not(HasSubstr("exit 75"))));
}

TEST(JobScript, EndsAsItsCommandDoes) {
  const fs::path folder = emptyFolder() / "with space";
  EXPECT_EQ(statusOf("exit_with() { return $1; }; exit_with 0", 0, folder), 0);
  const fs::path end = folder / "farm/render/ends/1";
  EXPECT_THAT(textIn(end), ::testing::StartsWith("0 n7 "));
  EXPECT_EQ(statusOf("sh -c 'exit 2'", 0, folder), 2) << "wrong input: no second try";
  EXPECT_THAT(textIn(end), ::testing::StartsWith("2 n7 "));
  EXPECT_EQ(statusOf("sh -c 'exit 3'", 0, folder), 3) << "no second try helps, it says";
}

TEST(JobScript, IsTriedAgainAFewTimes) {
  const fs::path folder = emptyFolder();
  EXPECT_EQ(statusOf("sh -c 'exit 75'", 0, folder), 75);
  EXPECT_EQ(statusOf("sh -c 'kill -9 $$'", 4, folder), 75);
  EXPECT_EQ(statusOf("sh -c 'kill -9 $$'", kMaxRestarts, folder), 3);
  EXPECT_EQ(statusOf("sh -c 'exit 75'", kMaxRestarts, folder), 3);
}

}  // namespace
}  // namespace rotatebook::farm
