#include "farm/slurm.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "farm/fake_slurm.h"
#include "messages.h"

namespace rotatebook::farm {
namespace {

using ::testing::ElementsAre;
using testing::emptyFolder;
using testing::FakeSlurm;

template <typename Action>
std::pair<std::string, ErrorKind> errorOf(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return {error.what(), error.kind()};
  }
  return {"", ErrorKind::Machine};
}

TEST(ClusterLimits, AreReadFromTheConfiguration) {
  const ClusterLimits limits = parseLimits(
      "Configuration data as of 2026-11-24T23:00:00\nMaxArraySize            = 4001\n"
      "MaxJobCount             = 10000\nRequeueExit             = 1,70-80\n"
      "SchedulerParameters     = bf_interval=1,max_array_tasks=500\n");
  EXPECT_EQ(limits.arraySize, 4001);
  EXPECT_TRUE(limits.requeues75);
  EXPECT_EQ(limits.maxTasks(), 500);
  const ClusterLimits few = parseLimits("MaxArraySize = 1001\nMaxJobCount = 300\n");
  EXPECT_EQ(few.maxTasks(), 299);  // and the join
  EXPECT_FALSE(few.requeues75);
}

TEST(ClusterLimits, AreSlurmsOwnByDefault) {
  EXPECT_EQ(parseLimits("").maxTasks(), 1000);
  EXPECT_FALSE(parseLimits("RequeueExit = (null)\n").requeues75);
  EXPECT_FALSE(parseLimits("RequeueExit = 175,7\nRequeueExitHold = 75\n").requeues75);
}

TEST(Queue, IsReadTaskByTask) {
  const std::vector<QueuedJob> jobs = parseQueue(
      "17|3|RUNNING|1-02:03:04|n2|None\n17|4|PENDING|0:00||Resources\n18|N/A|COMPLETED|0:09|n1|"
      "None\n");
  ASSERT_EQ(jobs.size(), 3U);
  EXPECT_EQ(jobs[0].job, "17");
  EXPECT_EQ(jobs[0].task, 3);
  EXPECT_EQ(jobs[0].seconds, 93'784);
  EXPECT_EQ(jobs[0].node, "n2");
  EXPECT_TRUE(jobs[0].isRunning());
  EXPECT_TRUE(jobs[1].isActive());
  EXPECT_FALSE(jobs[1].isRunning());
  EXPECT_EQ(jobs[1].reason, "Resources");
  EXPECT_EQ(jobs[2].task, 0);
  EXPECT_FALSE(jobs[2].isActive());
}

TEST(Processors, AreThoseOfThePartitionThatAreNotDown) {
  const std::string lines = "main*|2/4/1/7\ngpu|0/8/0/8\n";
  EXPECT_EQ(parseProcessors(lines, ""), 6);
  EXPECT_EQ(parseProcessors(lines, "gpu"), 8);
  EXPECT_EQ(parseProcessors(lines, "main"), 6);
  const auto [message, kind] = errorOf([&] { parseProcessors(lines, "gqu"); });
  EXPECT_EQ(kind, ErrorKind::Input);
  EXPECT_MESSAGE(message);
}

TEST(Slurm, SendsJobsAfterOthers) {
  const FakeSlurm slurm(emptyFolder());
  EXPECT_EQ(sendJob("/x/part.sh", {}), "101");
  EXPECT_EQ(sendJob("/x/join.sh", {"101", "99"}), "102");
  EXPECT_THAT(slurm.calls(), ElementsAre("sbatch --parsable part.sh",
                                         "sbatch --parsable --dependency=afterany:101:99 join.sh"));
}

TEST(Slurm, SaysWhatTheClusterRefuses) {
  const FakeSlurm slurm(emptyFolder());
  slurm.fail("sbatch",
             "sbatch: error: invalid account nope\nsbatch: error: Batch job submission failed: "
             "Invalid account or account/partition combination specified");
  const auto [message, kind] = errorOf([] { sendJob("part.sh", {}); });
  EXPECT_EQ(kind, ErrorKind::Input);
  EXPECT_MESSAGE(message);
}

TEST(Slurm, ThatDoesNotAnswerMayAnswerLater) {
  const FakeSlurm slurm(emptyFolder());
  slurm.fail("scontrol", "slurm_load_ctl_conf error: Unable to contact slurm controller");
  const auto [message, kind] = errorOf([] { readLimits(); });
  EXPECT_EQ(kind, ErrorKind::Transient);
  EXPECT_MESSAGE(message);
}

TEST(Slurm, ThatIsNotHereIsSaidWithTheRemedy) {
  const FakeSlurm slurm(emptyFolder());
  slurm.remove("sbatch");
  const auto [message, kind] = errorOf([] { sendJob("part.sh", {}); });
  EXPECT_EQ(kind, ErrorKind::Machine);
  EXPECT_MESSAGE(message);
}

TEST(Slurm, HasForgottenOldJobs) {
  const FakeSlurm slurm(emptyFolder());
  slurm.fail("squeue", "slurm_load_jobs error: Invalid job id specified");
  EXPECT_TRUE(readQueue({"7"}).empty());
  EXPECT_TRUE(readQueue({}).empty());
}

}  // namespace
}  // namespace rotatebook::farm
